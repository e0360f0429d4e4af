/* The completions of bash and zsh: commands, options and values. */
#include <stdbool.h>
#include <string.h>

#include "command_table.h"
#include "documents.h"
#include "option_table.h"

/* Whether the command has the option of this row. */
static bool has(const command_row *c, const option_row *row)
{
    return (row->commands & (int)c->which) != 0 && row->value.kind != OPTION_HEADING;
}

void write_bash(FILE *out)
{
    const option_row *const end = option_table + option_count;
    fputs("# Completion of gnomon's commands, options and values for bash. Source this file, or\n"
          "# install it as share/bash-completion/completions/gnomon.\n"
          "\n"
          "_gnomon()\n"
          "{\n"
          "    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}\n"
          "    local command=${COMP_WORDS[1]} options=\n"
          "\n"
          "    COMPREPLY=()\n"
          "    if [ \"$COMP_CWORD\" = 1 ]; then\n"
          "        COMPREPLY=($(compgen -W '",
          out);
    for (size_t i = 0; i < command_count; ++i)
        fprintf(out, "%s ", command_table[i].name);
    fputs("help --help --version' -- \"$word\"))\n"
          "        return\n"
          "    fi\n"
          "    # bash cuts --option=value into three words.\n"
          "    if [ \"$word\" = = ]; then\n"
          "        word=\n"
          "    elif [ \"$previous\" = = ]; then\n"
          "        previous=${COMP_WORDS[COMP_CWORD - 2]}\n"
          "    fi\n"
          "    case $command$previous in\n",
          out);
    for (const option_row *row = option_table; row < end; ++row)
        for (size_t i = 0; i < command_count; ++i)
            if (has(command_table + i, row) && row->words != NULL &&
                strcmp(row->words, "FILE") != 0)
                fprintf(out, "    %s--%s) options='%s' ;;\n", command_table[i].name, row->name,
                        row->words);
    fputs("    esac\n"
          "    if [ -n \"$options\" ]; then\n"
          "        COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
          "        return\n"
          "    fi\n"
          "    case $word in\n"
          "    -*) ;;\n"
          "    *) return ;; # a file\n"
          "    esac\n"
          "    case $command in\n",
          out);
    for (size_t i = 0; i < command_count; ++i) {
        fprintf(out, "    %s) options='", command_table[i].name);
        for (const option_row *row = option_table; row < end; ++row)
            if (has(command_table + i, row))
                fprintf(out, " --%s", row->name);
        fputs("' ;;\n", out);
    }
    fputs("    esac\n"
          "    COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
          "}\n"
          "\n"
          "complete -o filenames -o bashdefault -o default -F _gnomon gnomon\n",
          out);
}

/* Text within '' of a shell. */
static void write_quoted(const char *text, size_t length, FILE *out)
{
    for (size_t i = 0; i < length; ++i)
        if (text[i] == '\'')
            fputs("'\\''", out);
        else
            fputc(text[i], out);
}

/* The specification of an option for _arguments. */
static void write_specification(const option_row *row, FILE *out)
{
    const char *text = row->text != NULL ? row->text : row->brief;
    const bool repeats = row->value.kind >= OPTION_ROTATE;
    const bool is_optional = row->argument != NULL && row->argument[0] == '[';
    const bool ends = row->value.kind == OPTION_HELP || row->value.kind == OPTION_HELP_ALL;
    fputs("            ", out);
    if (option_letter(row) == 'o')
        fputs("'(-o --output)'{-o,--output}'[", out);
    else
        fprintf(out, "'%s--%s%s[",
                ends      ? "(- *)"
                : repeats ? "*"
                          : "",
                row->name, is_optional ? "=-" : "");
    write_quoted(text, strcspn(text, ",;:.("), out);
    fputc(']', out);
    if (is_optional)
        fprintf(out, "::%.*s:", (int)strlen(row->argument) - 3, row->argument + 2);
    else if (row->argument != NULL)
        fprintf(out, ":%s:", row->argument);
    if (row->words != NULL)
        fprintf(out, strcmp(row->words, "FILE") == 0 ? "_files" : "(%s)", row->words);
    fputs("'\n", out);
}

void write_zsh(FILE *out)
{
    fputs("#compdef gnomon\n"
          "# Completion of gnomon's commands, options and values for zsh. Install it into a\n"
          "# directory of fpath, such as share/zsh/site-functions.\n"
          "\n"
          "_gnomon()\n"
          "{\n"
          "    local -a commands own\n"
          "    commands=(\n",
          out);
    for (size_t i = 0; i < command_count; ++i) {
        fprintf(out, "        '%s:", command_table[i].name);
        write_quoted(command_table[i].title, strcspn(command_table[i].title, ",;:"), out);
        fputs("'\n", out);
    }
    fputs("    )\n"
          "\n"
          "    if (( CURRENT == 2 )); then\n"
          "        _describe command commands\n"
          "        _arguments '--help[print the commands]' '--version[print the version]'\n"
          "        return\n"
          "    fi\n"
          "    local command=$words[2]\n"
          "    shift words\n"
          "    (( CURRENT-- ))\n"
          "    case $command in\n",
          out);
    for (size_t i = 0; i < command_count; ++i) {
        fprintf(out, "    %s)\n        own=(\n", command_table[i].name);
        for (const option_row *row = option_table; row < option_table + option_count; ++row)
            if (has(command_table + i, row))
                write_specification(row, out);
        fputs(command_table[i].which == COMMAND_DEMO
                  ? "        ) ;;\n"
                  : "            '*:file:_files'\n        ) ;;\n",
              out);
    }
    fputs("    *)\n"
          "        return 1 ;;\n"
          "    esac\n"
          "    _arguments $own\n"
          "}\n"
          "\n"
          "_gnomon \"$@\"\n",
          out);
}
