use crate::declare::instruction;

instruction! {
    /// Links a numerical signal to the input or output that another one is linked to.
    ///
    /// - `aiVariable`: the variable that gets the link.
    /// - `aiSource`: the variable whose link is taken over.
    ///
    /// ## Example
    /// ```val3
    /// aio aiPressure
    /// aio aiBoard
    ///   if ioStatus(aiBoard)>=0
    ///     aioLink(aiPressure,aiBoard)
    ///   endIf
    /// ```
    "aioLink": Io "3.6.2";
    modifier (aio& aiVariable, aio aiSource);
}
