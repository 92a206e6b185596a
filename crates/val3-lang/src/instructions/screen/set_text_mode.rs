use crate::declare::instruction;

instruction! {
    /// Chooses how text that is written from now on looks.
    ///
    /// - `scPage`: the page; without it, the default page.
    /// - `nMode`: 0 dark on light, 1 light on dark, 2 and 3 the same, flashing. What is shown already stays.
    /// - Error 70: another mode.
    ///
    /// ## Example
    /// ```val3
    ///   setTextMode(2)
    ///   putln("guard open")
    ///   setTextMode(0)
    /// ```
    "setTextMode": Screen "4.3", errors [70];
    modifier (num nMode);
    modifier (screen scPage, num nMode);
}
