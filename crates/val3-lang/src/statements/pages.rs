//! Pages of the statements, in the manual's order.

use super::Statement;

macro_rules! statements {
    ($($(#[doc = $line:literal])* $name:literal [$($keyword:literal),*] $section:literal;)+) => {
        /// All statements, in the manual's order.
        pub static STATEMENTS: &[Statement] = &[$(
            Statement {
                name: $name,
                keywords: &[$($keyword),*],
                section: $section,
                page: concat!($($line, "\n"),*),
            }
        ),+];
    };
}

statements! {
    /// Encloses the instructions of a program.
    ///
    /// Code starts with `begin` and ends with `end`, each on a line of its own. `end` returns to the caller; in the
    /// first program of a task, it ends the task.
    ///
    /// ## Example
    /// ```val3
    /// public program greet()
    /// begin
    ///   putln("hello")
    /// end
    ///   call greet()
    /// ```
    "begin" ["begin", "end"] "2.2";
    /// Marks a line that is not executed.
    ///
    /// `//` must be the first text on its line; it cannot follow an instruction. Within a string it is text.
    ///
    /// ## Example
    /// ```val3
    ///   // the arm is in its park position
    ///   putln("Disk://data")
    /// ```
    "//" [] "2.2.5";
    /// Executes a program and continues when it has ended.
    ///
    /// The parentheses are required. Arguments are evaluated first, in their order, and must match the program's
    /// parameters in number, type and container. A parameter by reference (`&`) accepts a variable, but no computed
    /// value; an array parameter accepts a whole array, or a one-dimensional array from an index on. A program of a
    /// library is called `call library:p()`. Programs return no value.
    ///
    /// ## Example
    /// ```val3
    /// point pTray[3]
    /// num nIndex
    /// program pick(point x_pWhere)
    /// begin
    ///   putln(x_pWhere.trsf.z)
    /// end
    ///   for nIndex=0 to 2
    ///     call pick(pTray[nIndex])
    ///   endFor
    /// ```
    "call" ["call"] "2.2.5";
    /// Ends the program immediately.
    ///
    /// It has the effect of `end`, anywhere in the code, and returns no value. A program is easier to read if its last
    /// line is the only exit.
    ///
    /// ## Example
    /// ```val3
    /// dio diPart
    ///   if diPart==false
    ///     return
    ///   endIf
    ///   putln("part present")
    /// ```
    "return" ["return"] "2.2.5";
    /// Executes lines if a condition holds.
    ///
    /// The conditions are evaluated one after the other until one holds. The lines of this condition are executed, or
    /// the lines after `else` if none holds. There is no `then`. To compare one value with many, `switch` is shorter.
    ///
    /// ## Example
    /// ```val3
    /// num nSpeed = 50
    ///   if nSpeed<20
    ///     putln("slow")
    ///   elseIf nSpeed<80
    ///     putln("medium")
    ///   else
    ///     putln("fast")
    ///   endIf
    /// ```
    "if" ["if", "elseIf", "else", "endIf"] "2.2.5";
    /// Repeats lines as long as a condition holds.
    ///
    /// The condition is computed before each pass, so the lines may not be executed at all. A loop that waits for
    /// something needs a `delay` or another instruction that lets the other tasks run.
    ///
    /// ## Example
    /// ```val3
    /// dio doLamp
    ///   while isSettled()==false
    ///     doLamp=!doLamp
    ///     delay(0.5)
    ///   endWhile
    ///   doLamp=false
    /// ```
    "while" ["while", "endWhile"] "2.2.5";
    /// Repeats lines until a condition holds.
    ///
    /// The condition is evaluated after each pass, so the lines are executed at least once.
    ///
    /// ## Example
    /// ```val3
    /// num nKey
    ///   do
    ///     nKey=get()
    ///   until nKey==270
    /// ```
    "do" ["do", "until"] "2.2.5";
    /// Repeats lines while a counter runs from one number to another.
    ///
    /// The counter is a `num` variable or an element of an array. It starts at the first number and increases by the
    /// step after each pass; without `step` by 1. The loop ends when the counter is above the last number, or below it
    /// for a negative step. The lines may be skipped completely.
    ///
    /// ## Example
    /// ```val3
    /// joint jScan
    /// num nAngle
    /// mdesc mSlow
    ///   for nAngle=90 to -90 step -10
    ///     jScan.j1=nAngle
    ///     movej(jScan,flange,mSlow)
    ///     waitEndMove()
    ///   endFor
    /// ```
    "for" ["for", "to", "step", "endFor"] "2.2.5";
    /// Executes the lines of the first case that equals a value.
    ///
    /// Cases are compared in their order; one `case` may list several values. They have the type of the value, which
    /// can be any type that `==` compares. Every `case` and the `default` at the end have one closing `break`.
    ///
    /// ## Example
    /// ```val3
    /// num nMenu
    ///   nMenu=get()
    ///   switch nMenu
    ///     case 271
    ///       putln("start")
    ///     break
    ///     case 272, 273
    ///       putln("setup")
    ///     break
    ///     default
    ///       putln("no menu key")
    ///     break
    ///   endSwitch
    /// ```
    "switch" ["switch", "case", "break", "default", "endSwitch"] "2.2.5";
    /// Assigns a value to a variable.
    ///
    /// Value and variable have the same type; in addition, a `bool` can be assigned to a digital output and a digital
    /// input to a `bool`, and a `string` or one byte as a `num` can be assigned to and from a serial line. For a
    /// structured type, every field is copied, including the reference of a frame, tool or point. `a=b=0` assigns the
    /// value to both variables. Within any other expression `=` is not allowed: equality is tested with `==`.
    ///
    /// ## Example
    /// ```val3
    /// point pPick
    /// num nRow
    /// num nColumn
    ///   nRow=nColumn=0
    ///   pPick.trsf={400,0,300,0,180,0}
    ///   putln(nRow+nColumn)
    /// ```
    "=" [] "3.1.2, 2.4.2";
    /// Writes the value of an expression to the debug console.
    ///
    /// It is not in the manual; programs of s5, s7 and s8 use it. A program in production should not need it: `logMsg`
    /// writes to the event log.
    ///
    /// ## Example
    /// ```val3
    /// num nCount = 3
    ///   ? nCount+1
    /// ```
    "?" [] "";
    /// Combine truth values: `and`, `or`, `xor`, and `!` for negation.
    ///
    /// `!` binds tightest, then `xor`, then `and`, then `or`. `and` does not evaluate its right side if the left is
    /// `false`, and `or` does not if the left is `true`. Parentheses make a line with both of them readable.
    ///
    /// ## Example
    /// ```val3
    /// dio diPart
    /// dio diGuard
    /// num nCount
    ///   if diGuard==true and (diPart==true or nCount==0)
    ///     putln("go")
    ///   endIf
    /// ```
    "and" ["and", "or", "xor"] "3.1.2";
    /// The two truth values.
    ///
    /// ## Example
    /// ```val3
    /// bool bDone
    ///   bDone=true
    ///   wait(bDone)
    /// ```
    "true" ["true", "false"] "3.1.1";
}
