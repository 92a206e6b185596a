syntax case ignore
syntax keyword val3Keyword begin end call return if elseIf else endIf while endWhile do until for to step endFor
syntax keyword val3Keyword switch case break default endSwitch and or xor taskCreate taskCreateSync
syntax case match
syntax keyword val3Boolean true false
syntax match val3Comment "//.*$"
syntax region val3String start=+"+ end=+"\|$+
highlight default link val3Keyword Keyword
highlight default link val3Boolean Boolean
highlight default link val3Comment Comment
highlight default link val3String String
let b:current_syntax = 'val3-code'
