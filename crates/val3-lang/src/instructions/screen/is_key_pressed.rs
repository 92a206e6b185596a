use crate::declare::instruction;

instruction! {
    /// Tells whether a key is held down.
    ///
    /// - `scPage`: the page; without it, the default page. Keys count only while it is shown; the keys 1, 2 and 3
    ///   (codes 281 to 283) count always.
    /// - `nCode`: the code of the key (`get` lists codes).
    /// - Result: `true` while it is held down.
    ///
    /// ## Example
    /// ```val3
    /// dio doValve
    ///   doValve=isKeyPressed(281)
    /// ```
    "isKeyPressed": Screen "4.3";
    function (num nCode) -> bool;
    function (screen scPage, num nCode) -> bool;
}
