" XML, with colours for the keywords of code, which work without a server.
runtime! syntax/xml.vim
unlet! b:current_syntax
syntax case ignore
syntax keyword val3Keyword begin end call return if elseIf else endIf while endWhile do until for to step endFor contained
syntax keyword val3Keyword switch case break default endSwitch and or xor taskCreate taskCreateSync contained
syntax case match
syntax keyword val3Boolean true false contained
syntax match val3Comment "//.\{-}\ze\%(\]\]>\|$\)" contained
syntax region val3String start=+"+ end=+"\|$+ contained
syntax region val3Code start="<!\[CDATA\[\zebegin" end="\]\]>" keepend contains=val3Keyword,val3Boolean,val3Comment,val3String containedin=ALL
highlight default link val3Keyword Keyword
highlight default link val3Boolean Boolean
highlight default link val3Comment Comment
highlight default link val3String String
let b:current_syntax = 'val3'
