/* Finds the places of C sources that `make mutants` changes, and changes one. It reads tokens, not
 * syntax, and relies on the layout of .clang-format: a binary operator has white space on both
 * sides, a pointer's star only before it. What does not compile is drawn again. */
#include <ctype.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_TOKENS = 200000, MOST_NESTING = 256, MOST_TEXT = 4000 };

typedef enum token_kind { IDENTIFIER, NUMBER, TEXT, PUNCTUATION } token_kind;

typedef struct token {
    size_t at, length;
    int line;
    token_kind kind;
    size_t partner; /* of a bracket: the index of the other one */
} token;

/* What a pair of braces holds. */
typedef enum braces { BLOCK, INITIALISER, TYPE } braces;

typedef struct source {
    const char *file;
    char *text;
    size_t size;
    token *tokens;
    size_t count;
} source;

/* The mutations of a file are counted by their text, because one text may stand at two places of a
 * function. */
typedef struct counted_text {
    char *text;
    int times;
    struct counted_text *next;
} counted_text;

static counted_text *seen_texts[4096];
static uint64_t seed;
static source s;
static char function[200];

static void fail(const char *format, ...)
{
    va_list arguments;

    fputs("mutate: ", stderr);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    exit(2);
}

static void read_source(const char *file)
{
    FILE *f = fopen(file, "rb");
    size_t room = 1 << 20;

    if (!f)
        fail("%s cannot be read", file);
    s.file = file;
    s.text = malloc(room);
    s.tokens = malloc(MOST_TOKENS * sizeof *s.tokens);
    if (!s.text || !s.tokens)
        fail("out of memory");
    s.size = fread(s.text, 1, room - 1, f);
    if (s.size == room - 1)
        fail("%s is larger than %zu bytes", file, room);
    s.text[s.size] = 0;
    fclose(f);
}

/* Tokens */

/* Returns the length of what is skipped at `at`: white space, a comment, a directive. */
static size_t skipped(size_t at, bool begins_line)
{
    const char *text = s.text + at;
    const char *end;

    if (isspace((unsigned char)*text))
        return 1;
    if (!strncmp(text, "/*", 2)) {
        end = strstr(text + 2, "*/");
        return end ? (size_t)(end + 2 - text) : s.size - at;
    }
    if (!strncmp(text, "//", 2) || (begins_line && *text == '#')) {
        for (end = text; *end && (*end != '\n' || end[-1] == '\\'); ++end) {
        }
        return (size_t)(end - text);
    }
    return 0;
}

static size_t token_length(const char *text, token_kind *kind)
{
    static const char *const signs[] = {"<<=", ">>=", "...", "->", "++", "--", "<<", ">>",
                                        "<=",  ">=",  "==",  "!=", "&&", "||", "+=", "-=",
                                        "*=",  "/=",  "%=",  "&=", "|=", "^="};
    size_t n = 1;

    if (isalpha((unsigned char)*text) || *text == '_') {
        while (isalnum((unsigned char)text[n]) || text[n] == '_')
            ++n;
        *kind = IDENTIFIER;
    } else if (isdigit((unsigned char)*text) || (*text == '.' && isdigit((unsigned char)text[1]))) {
        while (isalnum((unsigned char)text[n]) || text[n] == '.' ||
               ((text[n] == '+' || text[n] == '-') && strchr("eEpP", text[n - 1]) &&
                (strncmp(text, "0x", 2) || strchr("pP", text[n - 1]))))
            ++n;
        *kind = NUMBER;
    } else if (*text == '"' || *text == '\'') {
        while (text[n] && text[n] != *text)
            n += text[n] == '\\' ? 2 : 1;
        *kind = TEXT;
        ++n;
    } else {
        *kind = PUNCTUATION;
        for (size_t i = 0; i < sizeof signs / sizeof *signs; ++i)
            if (!strncmp(text, signs[i], strlen(signs[i])))
                return strlen(signs[i]);
    }
    return n;
}

static bool is(size_t index, const char *text)
{
    return index < s.count && s.tokens[index].length == strlen(text) &&
           !memcmp(s.text + s.tokens[index].at, text, strlen(text));
}

static bool is_one_of(size_t index, const char *const *texts)
{
    for (; *texts; ++texts)
        if (is(index, *texts))
            return true;
    return false;
}

static void read_tokens(void)
{
    size_t open[MOST_NESTING];
    size_t depth = 0;
    int line = 1;
    bool begins_line = true;

    s.count = 0;
    for (size_t at = 0; at < s.size;) {
        size_t length = skipped(at, begins_line);

        if (length) {
            for (size_t i = 0; i < length; ++i)
                if (s.text[at + i] == '\n') {
                    ++line;
                    begins_line = true;
                }
        } else {
            token *t = &s.tokens[s.count];

            if (s.count + 1 >= MOST_TOKENS || depth + 1 >= MOST_NESTING)
                fail("%s:%d: too long or too deep", s.file, line);
            *t = (token){at, 0, line, IDENTIFIER, 0};
            t->length = length = token_length(s.text + at, &t->kind);
            begins_line = false;
            if (strchr("([{", s.text[at])) {
                open[depth++] = s.count;
            } else if (t->kind == PUNCTUATION && strchr(")]}", s.text[at]) && depth > 0) {
                t->partner = open[--depth];
                s.tokens[t->partner].partner = s.count;
            }
            ++s.count;
        }
        at += length;
    }
}

/* Mutations */

static uint64_t hashed(uint64_t hash, const char *text)
{
    for (; *text; ++text)
        hash = (hash ^ (unsigned char)*text) * 0x100000001b3u;
    return hash;
}

/* Spreads the bits of a number (David Stafford's variant 13 of MurmurHash3's finaliser). */
static uint64_t spread(uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

static int times_seen(const char *text)
{
    counted_text **place = &seen_texts[hashed(0, text) % 4096];

    while (*place && strcmp((*place)->text, text))
        place = &(*place)->next;
    if (!*place) {
        *place = calloc(1, sizeof **place);
        (*place)->text = malloc(strlen(text) + 1);
        strcpy((*place)->text, text);
    }
    return ++(*place)->times;
}

/* Copies text with every run of white space as one space. */
static size_t copy_line(char *to, size_t length, const char *from, size_t count)
{
    for (size_t i = 0; i < count && length + 2 < MOST_TEXT; ++i) {
        const bool space = isspace((unsigned char)from[i]);

        if (!space || (length && to[length - 1] != ' '))
            to[length++] = space ? ' ' : from[i];
    }
    to[length] = 0;
    return length;
}

/* Prints the mutation that replaces `length` bytes at `at`: a number by which mutations are sorted,
 * file, line, function, place, length, replacement, and the lines before and after. The number
 * depends on the seed and on these texts alone, so that changes elsewhere change no other
 * mutation's turn. */
static void mutation(size_t at, size_t length, int line, const char *replacement)
{
    char before[MOST_TEXT], after[MOST_TEXT], key[3 * MOST_TEXT];
    size_t begin = at, end = at + length, n;
    int times;

    while (begin > 0 && s.text[begin - 1] != '\n')
        --begin;
    while (end < s.size && s.text[end] != '\n')
        ++end;
    while (begin < at && isspace((unsigned char)s.text[begin]))
        ++begin;
    copy_line(before, 0, s.text + begin, end - begin);
    n = copy_line(after, 0, s.text + begin, at - begin);
    n = copy_line(after, n, replacement, strlen(replacement));
    copy_line(after, n, s.text + at + length, end - at - length);
    snprintf(key, sizeof key, "%s %s %s %s", s.file, function, before, after);
    times = times_seen(key);
    if (times > 1)
        snprintf(after + strlen(after), 20, " /* %d */", times);
    printf("%016" PRIx64 "\t%s\t%d\t%s\t%zu\t%zu\t%s\t%s\t%s\n",
           spread(hashed(spread(seed), key) + (uint64_t)times), s.file, line, function, at, length,
           replacement, before, after);
}

static void replace(size_t index, const char *format, ...)
{
    char text[MOST_TEXT];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    mutation(s.tokens[index].at, s.tokens[index].length, s.tokens[index].line, text);
}

static bool space_before(size_t index)
{
    return isspace((unsigned char)s.text[s.tokens[index].at - 1]);
}

static bool space_after(size_t index)
{
    return isspace((unsigned char)s.text[s.tokens[index].at + s.tokens[index].length]);
}

static void mutate_sign(size_t index)
{
    static const char *const binary[][3] = {
        {"+", "-"},       {"-", "+"},   {"*", "+"},        {"/", "*"},        {"%", "/"},
        {"<<", ">>"},     {">>", "<<"}, {"&", "|"},        {"|", "&"},        {"^", "|"},
        {"&&", "||"},     {"||", "&&"}, {"<", "<=", ">="}, {">", ">=", "<="}, {"<=", "<", ">"},
        {">=", ">", "<"}, {"==", "!="}, {"!=", "=="},      {"+=", "-="},      {"-=", "+="},
        {"*=", "+="},     {"/=", "*="}, {"%=", "/="},      {"<<=", ">>="},    {">>=", "<<="},
        {"|=", "&="},     {"&=", "|="}, {"^=", "|="}};
    static const char *const unary[][2] = {
        {"!", ""}, {"-", ""}, {"~", ""}, {"++", "--"}, {"--", "++"}};

    if (space_before(index) && space_after(index)) {
        for (size_t i = 0; i < sizeof binary / sizeof *binary; ++i)
            if (is(index, binary[i][0])) {
                replace(index, "%s", binary[i][1]);
                if (binary[i][2])
                    replace(index, "%s", binary[i][2]);
            }
    } else {
        for (size_t i = 0; i < sizeof unary / sizeof *unary; ++i)
            if (is(index, unary[i][0]))
                replace(index, "%s", unary[i][1]);
    }
}

static void mutate_number(size_t index)
{
    char text[200];
    const token *t = &s.tokens[index];
    bool hexadecimal, real;

    if (t->length >= sizeof text)
        return;
    memcpy(text, s.text + t->at, t->length);
    text[t->length] = 0;
    hexadecimal = !strncmp(text, "0x", 2);
    real = strchr(text, '.') || strpbrk(text, hexadecimal ? "pP" : "eE");
    if (real) {
        const char *suffix = text[t->length - 1] == 'f' ? "f" : "";

        if (strtod(text, 0) == 0) {
            replace(index, "1.0%s", suffix);
        } else {
            replace(index, "0.0%s", suffix);
            replace(index, "(%s * 1.001%s)", text, suffix);
        }
    } else {
        replace(index, "(%s + 1)", text);
        if (strtoull(text, 0, 0) != 0)
            replace(index, "(%s - 1)", text);
    }
}

/* Statements */

static const char *const type_words[] = {
    "const", "static", "struct", "union",    "enum", "unsigned", "int",     "float", "uint32_t",
    "char",  "bool",   "double", "volatile", "void", "size_t",   "typedef", 0};
static const char *const no_expressions[] = {"if",   "for",  "while",   "switch", "do",
                                             "else", "case", "default", "goto",   0};

static bool is_declaration(size_t index)
{
    if (is_one_of(index, type_words))
        return true;
    if (s.tokens[index].kind != IDENTIFIER || is(index, "return"))
        return false;
    return s.tokens[index + 1].kind == IDENTIFIER ||
           (is(index + 1, "*") && !space_after(index + 1));
}

/* Returns the index of the semicolon that ends the statement, or 0. */
static size_t end_of_statement(size_t index)
{
    for (; index < s.count; ++index) {
        if (is(index, ";"))
            return index;
        if (is(index, "(") || is(index, "[") || is(index, "{"))
            index = s.tokens[index].partner;
        else if (is(index, ")") || is(index, "]") || is(index, "}"))
            return 0;
    }
    return 0;
}

/* Leaves a statement out. A function's last `return` stays: without it the result is undefined. */
static void leave_out(size_t index)
{
    const size_t end = end_of_statement(index);
    const bool is_cast_to_void = is(index, "(") && is(index + 1, "void");

    if (!end || end == index || is_one_of(index, no_expressions) || is_declaration(index) ||
        is_cast_to_void)
        return;
    if (is(index, "return") && (is(end + 1, "}") || is(end + 1, "case") || is(end + 1, "default")))
        return;
    mutation(s.tokens[index].at, s.tokens[end].at - s.tokens[index].at, s.tokens[index].line, "");
}

/* Negates the condition in the parenthesis. */
static void negate(size_t open)
{
    const token *t = &s.tokens[open];
    const size_t length = s.tokens[t->partner].at - t->at - 1;
    char text[MOST_TEXT];
    size_t n = copy_line(text, 0, "!(", 2);

    if (length + 8 > sizeof text)
        return;
    n = copy_line(text, n, s.text + t->at + 1, length);
    copy_line(text, n, ")", 1);
    mutation(t->at + 1, length, t->line, text);
}

/* Tells what the braces hold that open here, inside `outer`. */
static braces kind_of_braces(size_t index, size_t depth, braces outer)
{
    static const char *const before_blocks[] = {"else", "do", "{", "}", ";", ":", 0};
    size_t before;

    if (outer != BLOCK && depth > 0)
        return outer;
    if (index > 0 && is(index - 1, "="))
        return INITIALISER;
    if (index > 0 && is(index - 1, ")")) {
        before = s.tokens[index - 1].partner;
        return before > 0 && s.tokens[before - 1].kind == IDENTIFIER && !is(before - 1, "return")
                   ? BLOCK
                   : INITIALISER;
    }
    if (depth > 0)
        return is_one_of(index - 1, before_blocks) ? BLOCK : INITIALISER;
    return TYPE;
}

static bool begins_statement(size_t index)
{
    static const char *const ends[] = {";", "{", "}", "else", "do", 0};
    static const char *const conditions[] = {"if", "for", "while", "switch", 0};
    static const char *const beginnings[] = {"*", "(", "++", "--", 0};
    size_t open;

    if (s.tokens[index].kind != IDENTIFIER && !is_one_of(index, beginnings))
        return false;
    if (is_one_of(index - 1, ends))
        return true;
    if (is(index - 1, ":")) /* after `case X:`, not in a choice `a ? b : c` */
        return is(index - 2, "default") || is(index - 3, "case");
    open = s.tokens[index - 1].partner;
    return is(index - 1, ")") && open > 0 && is_one_of(open - 1, conditions);
}

static void name_function(size_t body)
{
    const token *name = &s.tokens[s.tokens[body - 1].partner - 1];

    snprintf(function, sizeof function, "%.*s", (int)name->length, s.text + name->at);
}

/* An object outside of functions: the identifier before `=` or before the dimensions. */
static void name_object(size_t index)
{
    while (is(index - 1, "]"))
        index = s.tokens[index - 1].partner;
    snprintf(function, sizeof function, "%.*s", (int)s.tokens[index - 1].length,
             s.text + s.tokens[index - 1].at);
}

static bool is_assertion(size_t index)
{
    const token *t = &s.tokens[index];
    char name[100];

    if (t->kind != IDENTIFIER || t->length >= sizeof name)
        return false;
    memcpy(name, s.text + t->at, t->length);
    name[t->length] = 0;
    for (char *c = name; *c; ++c)
        *c = (char)tolower((unsigned char)*c);
    return strstr(name, "static_assert") != 0;
}

static void mutate_token(size_t index, bool in_dimensions)
{
    if (s.tokens[index].kind == NUMBER) {
        if (!in_dimensions)
            mutate_number(index);
    } else if (s.tokens[index].kind == PUNCTUATION) {
        mutate_sign(index);
    } else if (is(index, "true")) {
        replace(index, "false");
    } else if (is(index, "false")) {
        replace(index, "true");
    } else if ((is(index, "if") || is(index, "while")) && is(index + 1, "(")) {
        negate(index + 1);
    }
}

static void list_mutations(void)
{
    braces open[MOST_NESTING];
    size_t depth = 0, parentheses = 0, dimensions_end = 0;
    bool is_declared = false;

    strcpy(function, "-");
    for (size_t i = 1; i < s.count; ++i) {
        const bool is_code = depth > 0 && open[depth - 1] != TYPE;

        if (is_assertion(i) && is(i + 1, "(")) {
            i = s.tokens[i + 1].partner;
            continue;
        }
        if (is_code && open[depth - 1] == BLOCK && parentheses == 0 && begins_statement(i)) {
            is_declared = is_declaration(i);
            leave_out(i);
        }
        if (is(i, "=") && parentheses == 0)
            is_declared = false;
        if (is(i, "[") && is_declared && parentheses == 0)
            dimensions_end = s.tokens[i].partner;
        if (is(i, "(")) {
            ++parentheses;
        } else if (is(i, ")")) {
            --parentheses;
        } else if (is(i, "{")) {
            open[depth] = kind_of_braces(i, depth, depth ? open[depth - 1] : BLOCK);
            if (depth == 0 && open[depth] == BLOCK)
                name_function(i);
            else if (depth == 0 && open[depth] == INITIALISER)
                name_object(i - 1);
            ++depth;
        } else if (is(i, "}") && depth > 0) {
            --depth;
        } else if (is_code) {
            mutate_token(i, i < dimensions_end);
        }
    }
}

/* Commands */

static void apply(const char *file, const char *at, const char *length, const char *replacement)
{
    const size_t begin = strtoull(at, 0, 10);
    const size_t end = begin + strtoull(length, 0, 10);

    read_source(file);
    if (begin > end || end > s.size)
        fail("%s has no byte %zu", file, end);
    fwrite(s.text, 1, begin, stdout);
    fputs(replacement, stdout);
    fwrite(s.text + end, 1, s.size - end, stdout);
}

static const char usage[] =
    "usage: mutate --list SEED FILE...\n"
    "       mutate --apply FILE PLACE LENGTH REPLACEMENT\n"
    "--list prints every mutation of the files, one a line, with tabs between: a number that "
    "depends on\n"
    "the seed (sorted by it, mutations stand in a random order), file, line, function, place, "
    "length,\n"
    "replacement, the line before, the line after. --apply prints the file with one of them.\n";

int main(int count, char **arguments)
{
    if (count == 2 && !strcmp(arguments[1], "--help")) {
        fputs(usage, stdout);
        return 0;
    }
    if (count >= 4 && !strcmp(arguments[1], "--list")) {
        seed = strtoull(arguments[2], 0, 10);
        for (int n = 3; n < count; ++n) {
            read_source(arguments[n]);
            read_tokens();
            list_mutations();
            free(s.text);
            free(s.tokens);
        }
        return 0;
    }
    if (count == 6 && !strcmp(arguments[1], "--apply")) {
        apply(arguments[2], arguments[3], arguments[4], arguments[5]);
        return 0;
    }
    fputs(usage, stderr);
    return 2;
}
