" Files of the controller have no line end at their end, and keep it so.
setlocal commentstring=//\ %s shiftwidth=2 expandtab nofixendofline
let b:undo_ftplugin = 'setlocal commentstring< shiftwidth< expandtab< fixendofline<'
