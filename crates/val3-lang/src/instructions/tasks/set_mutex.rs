//! `setMutex` (5.10): waits until a flag is `false` and sets it to `true` in one step.

use crate::call::{Call, Flow, Var, Wait};
use crate::declare::instruction;
use crate::fault::Result;

instruction! {
    /// Waits until a flag is `false` and sets it to `true` in one step.
    ///
    /// - `bMutex`: the flag that protects a resource which tasks share: the arm, the screen, a socket. It is `false` at
    ///   first, and the task that has set it resets it to `false`.
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
    modifier (bool& bMutex) = set_mutex;
}

fn set_mutex(call: &mut Call<'_>, mutex: Var<bool>) -> Result<Flow> {
    if mutex.get(call)? {
        return Ok(Flow::Wait(Wait::default()));
    }
    mutex.set(call, true)?;
    Ok(Flow::Done(()))
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    #[test]
    fn waits_until_the_flag_is_free_and_takes_it() {
        let mut bench = Bench::default().global("bool bScreen");
        assert_eq!([bench.run("setMutex(bScreen)"), bench.show("bScreen")], ["", "true"]);
        assert_eq!([bench.run("setMutex(bScreen)"), bench.run("setMutex(bScreen)")], ["waits", "waits"]);
        bench.set("bScreen", &[0.0]);
        assert_eq!([bench.run("setMutex(bScreen)"), bench.show("bScreen")], ["", "true"]);
    }
}
