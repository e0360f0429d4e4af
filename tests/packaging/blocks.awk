# Prints the blocks of code of a page, those between lines ```LANGUAGE and ```, one after the other.
# usage: awk [-v language=c] [-v info=TEXT] [-v first=1] [-v folder=DIRECTORY/] -f blocks.awk PAGE
# `info` is what follows the language; `first` prints the first block only. With `folder`, each block
# becomes a file there, named by the number of the line before it.

BEGIN {
    wanted = "```" (language == "" ? "c" : language) (info == "" ? "" : " " info)
    file = "/dev/stdout"
}
/^```/ {
    if (fence == "") {
        fence = $0
        if (folder != "")
            file = folder sprintf("%05d", FNR)
    } else {
        if (first && fence == wanted)
            exit
        fence = ""
    }
    next
}
fence == wanted { print > file }
