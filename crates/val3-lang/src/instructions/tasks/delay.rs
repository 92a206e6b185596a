use crate::declare::instruction;

instruction! {
    /// Waits for a time.
    ///
    /// - `nSeconds`: seconds; 0 or less only lets the other tasks have their turn.
    ///
    /// A loop that waits for nothing else needs a `delay(0)`: it would take the time of the others.
    ///
    /// ## Example
    /// ```val3
    /// dio doLamp
    ///   doLamp=true
    ///   delay(0.5)
    ///   doLamp=false
    /// ```
    "delay": Tasks "5.10", blocking;
    modifier (num nSeconds);
}
