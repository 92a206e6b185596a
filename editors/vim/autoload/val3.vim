" The server of VAL 3 for ALE.

call ale#Set('val3_executable', 'val3')

" The files of a cell have three types; one server knows them all.
function! val3#DefineLinter(filetype) abort
    call ale#linter#Define(a:filetype, {
    \   'name': 'val3',
    \   'lsp': 'stdio',
    \   'executable': {buffer -> ale#Var(buffer, 'val3_executable')},
    \   'command': '%e lsp',
    \   'language': a:filetype,
    \   'project_root': function('val3#ProjectRoot'),
    \})
endfunction

" The cell, which has the folder usr; else the configuration; else the folder of the file.
function! val3#ProjectRoot(buffer) abort
    for l:marker in ['usr/', 'val3.toml']
        let l:found = l:marker =~# '/$' ? ale#path#FindNearestDirectory(a:buffer, l:marker) : ale#path#FindNearestFile(a:buffer, l:marker)
        if !empty(l:found)
            return fnamemodify(l:found, l:marker =~# '/$' ? ':h:h' : ':h')
        endif
    endfor
    return expand('#' . a:buffer . ':p:h')
endfunction
