# fish completion of isogloss: the command itself tells what fits (isogloss complete --help).
function __isogloss_complete
    set -l words (commandline -opc)
    set -l current (commandline -ct)
    set -l kept ''
    if string match -qr -- '^-[^=]*=' $current
        set kept (string replace -r -- '=.*' '=' $current)
    end
    for line in ($words[1] complete -- $words[2..-1] "$current" 2>/dev/null)
        switch $line
            case ':files *'
                set -l pattern (string replace -- ':files ' '' $line)
                for file in (__fish_complete_path (string replace -- "$kept" '' "$current"))
                    # Folders lead to files whose names match.
                    set -l name (string split -m 1 \t -- $file)[1]
                    if string match -q -- '*/' $name; or string match -q -- $pattern $name
                        echo $kept$file
                    end
                end
            case ':folders'
                for folder in (__fish_complete_directories (string replace -- "$kept" '' "$current") '')
                    echo $kept$folder
                end
            case ':*'
            case '*'
                echo $kept$line
        end
    end
end
complete -c isogloss -f -a '(__isogloss_complete)'
