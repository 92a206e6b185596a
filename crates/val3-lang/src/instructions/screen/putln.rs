use crate::declare::instruction;

instruction! {
    /// Writes text or a number on a user page and goes to the next line.
    ///
    /// - `scPage`: the page; without it, the default page.
    /// - `sText`: the text.
    /// - `nValue`: the number, shown with up to 3 decimals.
    ///
    /// A full line goes on in the next one, and a full page scrolls up.
    ///
    /// ## Example
    /// ```val3
    /// num nDone = 12
    ///   putln("parts")
    ///   putln(nDone)
    /// ```
    "putln": Screen "4.3";
    modifier (string sText);
    modifier (screen scPage, string sText);
    modifier (num nValue);
    modifier (screen scPage, num nValue);
}
