# SPDX-License-Identifier: GPL-3.0-or-later
# What a page has, from cmark-gfm's XML (one element a line): the text of its
# headings, its links and pictures, and the paths of the repository
# and of the package (etc/makePackage) in code.

# attribute(name): of the element in this line
function attribute(name,    s)
{
    s = $0
    if (!sub(".* " name "=\"", "", s)) return ""
    sub(/".*/, "", s)
    return s
}

# text(): of the element in this line
function text(    s)
{
    s = $0
    sub(/^ *<[^>]*>/, "", s)
    sub(/<\/[a-z_]*>$/, "", s)
    return s
}

function paths(s,    i, n, word)
{
    n = split(s, word, /[^A-Za-z0-9_.\/*{},+-]+/)
    for (i = 1; i <= n; i++)
    {
        sub(/[.,]+$/, "", word[i])
        if (word[i] ~ /^(src|doc|etc|tutorials|validation|applications)\/./)
            print "path", word[i]
        if (word[i] ~ /^\/usr\/(lib|share|share\/doc)\/interdemfoam\/./)
            print "installed", word[i]
    }
}

/^ *<heading / { inside = 1; heading = "" }
/^ *<\/heading>/ { inside = 0; print "heading", heading }
inside && /^ *<(text|code) / { heading = heading text() }
/^ *<link / { print "link", attribute("destination") }
/^ *<image / { print "image", attribute("destination") }
/^ *<code / { paths(text()) }
/^ *<code_block / { block = 1 }
block { paths($0) }
/<\/code_block>/ { block = 0 }
