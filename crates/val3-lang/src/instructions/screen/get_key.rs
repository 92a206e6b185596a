use crate::declare::instruction;

instruction! {
    /// Reads the last key that was pressed, without waiting.
    ///
    /// - `scPage`: the page; without it, the default page. Only the page that is shown gets keys.
    /// - Result: the code of the last key since the call before (`get` lists codes); -1 if none was pressed.
    ///
    /// Call it once alone to forget an older key.
    ///
    /// ## Example
    /// ```val3
    ///   getKey()
    ///   while getKey()==-1
    ///     gotoxy(0,0)
    ///     put(toString(".1",clock()))
    ///     delay(0.1)
    ///   endWhile
    /// ```
    "getKey": Screen "4.3";
    modifier () -> num;
    modifier (screen scPage) -> num;
}
