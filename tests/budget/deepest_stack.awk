# Deepest stack of every entry point, from the call graphs that gcc -fcallgraph-info=su writes.
#
#   awk -v library_bytes=512 -f deepest_stack.awk *.ci
#
# Prints "stack_ENTRY bytes" for each function named tr_..., then the counts of what would make a depth unknown.
# Functions of the C library have no entry in the graphs: each counts with `library_bytes`, and is listed on stderr.

function quoted(text, key) {
    if (!match(text, key ": \"[^\"]*\"")) return ""
    return substr(text, RSTART + length(key) + 3, RLENGTH - length(key) - 4)
}

# Without the file in front: a template is in several objects, and the linker keeps one. The largest counts. Constructors of
# a complete object are another name for those of a base.
function function_name(text, key,    name) {
    name = quoted(text, key)
    sub(/^[^:]*:/, "", name)
    if (name ~ /^_Z/ && match(name, /C1[EI]/)) name = substr(name, 1, RSTART) "2" substr(name, RSTART + 2)
    return name
}

/^node:/ {
    title = function_name($0, "title")
    label = quoted($0, "label")
    if (match(label, /[0-9]+ bytes \([a-z,]*\)/)) {
        usage = substr(label, RSTART, RLENGTH)
        split(usage, part, " ")
        if (!(title in bytes) || part[1] + 0 > bytes[title]) bytes[title] = part[1] + 0
        if (usage ~ /dynamic/ && usage !~ /bounded/) { ++unbounded; print "unbounded: " title >"/dev/stderr" }
    }
}

/^edge:/ {
    from = function_name($0, "sourcename")
    to = function_name($0, "targetname")
    if (!((from, to) in known)) {
        known[from, to]
        callee[from, ++callees[from]] = to
    }
}

# Bytes below and including a function; each is visited once.
function depth(f,    k, below, deepest) {
    if (f in done) return done[f]
    if (f == "__indirect_call") { ++indirect; return 0 }
    if (!(f in bytes)) {
        print "of the C library: " f >"/dev/stderr"
        return done[f] = library_bytes
    }
    if (f in visiting) { ++recursive; print "recursive: " f >"/dev/stderr"; return 0 }
    visiting[f]
    for (k = 1; k <= callees[f]; ++k) {
        below = depth(callee[f, k])
        if (below > deepest) { deepest = below; via[f] = callee[f, k] }
    }
    delete visiting[f]
    return done[f] = bytes[f] + deepest
}

END {
    for (f in bytes) if (f ~ /^tr_/) {
        ++entries
        name = f
        sub(/_0x[0-9a-f]+u$/, "", name)  # some carry the version of the interface
        print "stack_" name, depth(f)
        if (paths) for (g = f; g != ""; g = via[g]) print "    " bytes[g] + 0, g >"/dev/stderr"
    }
    if (entries == 0) { print "no entry point in the call graphs" >"/dev/stderr"; exit 1 }
    print "recursive_functions", recursive + 0
    print "unbounded_stack_frames", unbounded + 0
    print "indirect_calls", indirect + 0
}
