" Vim with ALE and the files of editors/vim, as a user's configuration would have them.
set nocompatible
let s:root = $VAL3_ROOT
let s:passed = 0
let s:folder = tempname()
let s:application = s:folder . '/usr/usrapp/palletiser/'
let $VAL3_TRACE = $VAL3_OUTPUT . '/traces/vim.jsonl'
let g:val3_command = s:root . '/tests/editors/record'
let g:ale_val3_executable = g:val3_command
let g:ale_lint_on_text_changed = 'never'
execute 'set runtimepath^=' . s:root . '/editors/vim'
set runtimepath+=/usr/share/vim-ale
filetype plugin on
syntax on

function! s:Say(text) abort
    call writefile([a:text], '/dev/stdout', 'a')
endfunction

function! s:Until(what, holds) abort
    for l:attempt in range(500)
        if a:holds()
            return
        endif
        sleep 20m
    endfor
    throw 'no ' . a:what
endfunction

function! s:Step(name, run) abort
    call a:run()
    let s:passed += 1
    call s:Say('ok ' . a:name)
endfunction

function! s:Found(text) abort
    return !empty(filter(copy(ale#engine#GetLoclist(bufnr(''))), {_, found -> found.text =~# a:text}))
endfunction

function! s:Place(text) abort
    call cursor(1, 1)
    call assert_true(search('\V' . a:text, 'cW') > 0, a:text)
endfunction

function! s:Program() abort
    execute 'edit ' . s:application . 'pick.pgx'
    call s:Place('waitEndMove()')
    execute "normal! f(a1\<Esc>"
    ALELint
    call s:Until('finding', {-> s:Found('waitEndMove')})
    normal! u
    ALELint
    call s:Until('repair', {-> !s:Found('waitEndMove')})
endfunction

function! s:Data() abort
    execute 'edit ' . s:application . 'palletiser.dtx'
    call s:Place('type="tool"')
    execute "normal! f\"lrX"
    ALELint
    call s:Until('finding in the data', {-> !empty(ale#engine#GetLoclist(bufnr('')))})
    edit!
endfunction

function! s:Project() abort
    execute 'edit ' . s:application . 'palletiser.pjx'
    call s:Place('pick.pgx')
    normal! rX
    ALELint
    call s:Until('finding in the project', {-> s:Found('Xick')})
    edit!
endfunction

function! s:Definition() abort
    execute 'edit ' . s:application . 'pick.pgx'
    call s:Place('tSuction,mSlow')
    ALEGoToDefinition
    call s:Until('jump', {-> expand('%:t') ==# 'palletiser.dtx'})
endfunction

function! s:Run() abort
    call system('cp -r ' . shellescape(s:root . '/examples/palletiser') . ' ' . shellescape(s:folder))
    try
        call s:Step('a mistake in a program is shown and disappears', function('s:Program'))
        call s:Step('a mistake in data is shown', function('s:Data'))
        call s:Step('a program that the project lists and the folder lacks is shown', function('s:Project'))
        call s:Step('definition leads to the data', function('s:Definition'))
    catch
        call s:Say('FAILED ' . v:exception . ' ' . v:throwpoint)
        let v:errors += [v:exception]
    endtry
    let l:failed = empty(v:errors) ? 0 : 1
    call s:Say(printf('test result: %s. %d passed; %d failed; vim', l:failed ? 'FAILED' : 'ok', s:passed, l:failed))
    execute l:failed ? 'cquit' : 'qall!'
endfunction

autocmd VimEnter * ++nested call s:Run()
