use crate::declare::instruction;

instruction! {
    /// Writes text or a number on a user page and stays on the line.
    ///
    /// - `scPage`: the page; without it, the default page.
    /// - `sText`: the text.
    /// - `nValue`: the number, shown with up to 3 decimals.
    ///
    /// Writing starts at the cursor and ends behind the last character; a full line goes on in the next one, and a
    /// full page scrolls up.
    ///
    /// ## Example
    /// ```val3
    /// num nDone = 12
    ///   put("parts: ")
    ///   put(nDone)
    ///   putln("")
    /// ```
    "put": Screen "4.3";
    modifier (string sText);
    modifier (screen scPage, string sText);
    modifier (num nValue);
    modifier (screen scPage, num nValue);
}
