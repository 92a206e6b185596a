use crate::declare::instruction;

instruction! {
    /// Waits until a flag is `false` and sets it to `true` in one step.
    ///
    /// - `bMutex`: the flag that guards something which tasks share: the arm, the screen, a socket. It starts as
    ///   `false`, and whoever has set it puts it back to `false`.
    ///
    /// ## Example
    /// ```val3
    /// bool bScreen
    /// num nDone
    ///   setMutex(bScreen)
    ///   gotoxy(0,3)
    ///   put(nDone)
    ///   bScreen=false
    /// ```
    "setMutex": Tasks "5.10", blocking;
    modifier (bool& bMutex);
}
