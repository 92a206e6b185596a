use crate::declare::instruction;

instruction! {
    /// Moves the cursor of a user page.
    ///
    /// - `scPage`: the page; without it, the default page.
    /// - `nX`: column, 0 to 39 (modulo 40).
    /// - `nY`: line, 0 to 13 (modulo 14); (0,0) is the upper left corner.
    ///
    /// ## Example
    /// ```val3
    /// num nDone
    ///   gotoxy(0,2)
    ///   put("parts: ")
    ///   put(nDone)
    /// ```
    "gotoxy": Screen "4.3";
    modifier (num nX, num nY);
    modifier (screen scPage, num nX, num nY);
}
