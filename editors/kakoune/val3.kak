# VAL 3, the language of Stäubli robots: programs (.pgx), data (.dtx) and projects (.pjx), with the server through kak-lsp.

hook global BufCreate .*\.(pgx|PGX) %{ set-option buffer filetype val3 }
hook global BufCreate .*\.(dtx|DTX) %{ set-option buffer filetype val3-data }
hook global BufCreate .*\.(pjx|PJX) %{ set-option buffer filetype val3-project }

# Colours of the XML and of the code inside.
add-highlighter shared/val3 regions
add-highlighter shared/val3/default default-region group
add-highlighter shared/val3/default/ regex </?[\w:]+ 0:keyword
add-highlighter shared/val3/default/ regex \b[\w:]+= 0:attribute
add-highlighter shared/val3/default/ regex (?i)\b(begin|end|call|return|if|elseIf|else|endIf|while|endWhile|do|until|for|to|step|endFor|switch|case|break|default|endSwitch|and|or|xor|taskCreate|taskCreateSync)\b 0:keyword
add-highlighter shared/val3/default/ regex \b(true|false|\d+(\.\d+)?)\b 0:value
add-highlighter shared/val3/string region '"' '"|$' fill string
add-highlighter shared/val3/xml-comment region <!-- --> fill comment
add-highlighter shared/val3/comment region ^\h*// $ fill comment

hook -group val3 global WinSetOption filetype=val3(-data|-project)? %{
    add-highlighter window/val3 ref val3
    hook -once -always window WinSetOption filetype=.* %{ remove-highlighter window/val3 }
}

hook -group val3 global BufSetOption filetype=val3 %{
    set-option buffer comment_line //
    set-option buffer indentwidth 2
}

# Without kak-lsp there is no such option.
hook -group lsp-filetype-val3 global BufSetOption filetype=val3(-data|-project)? %{ try %{
    set-option buffer lsp_servers %{
        [val3]
        command = "val3"
        args = ["lsp"]
        root_globs = ["usr", "val3.toml", ".git"]
    }
} }
