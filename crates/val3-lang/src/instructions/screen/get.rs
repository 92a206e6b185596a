use crate::declare::instruction;

instruction! {
    /// Waits for the operator: a text, a number or a key.
    ///
    /// - `scPage`: the page; without it, the default page. Only the page that is shown gets keys.
    /// - `sText`, `nValue`: shown at the cursor and edited by the operator. Return or a menu key accepts the entry, Esc
    ///   leaves the variable as it was. Without it any key ends the wait, and it is not shown.
    /// - Result: the code of the key: 270 Return, 255 Esc, 271 to 278 the menu keys F1 to F8, 261, 264, 266 and 268
    ///   the arrows up, left, down and right; for a character its ASCII code.
    ///
    /// The cursor does not move. Other tasks run on.
    ///
    /// ## Example
    /// ```val3
    /// num nSpeed = 50
    /// num nKey
    ///   put("speed: ")
    ///   nKey=get(nSpeed)
    ///   if nKey==270
    ///     putln("accepted")
    ///   endIf
    /// ```
    "get": Screen "4.3", blocking;
    modifier (string& sText) -> num;
    modifier (screen scPage, string& sText) -> num;
    modifier (num& nValue) -> num;
    modifier (screen scPage, num& nValue) -> num;
    modifier () -> num;
    modifier (screen scPage) -> num;
}
