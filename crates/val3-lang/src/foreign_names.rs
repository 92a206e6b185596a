//! Names of other languages and their VAL 3 equivalents.

/// VAL 3 equivalent of a name in another language, in upper or lower case: ``"`delay(nSeconds)`"`` for `sleep`.
///
/// ```
/// use val3_lang::foreign_names::remedy;
/// assert!(remedy("Sleep").is_some_and(|remedy| remedy.contains("delay(")));
/// assert_eq!(remedy("pick"), None);
/// ```
#[must_use]
pub fn remedy(name: &str) -> Option<&'static str> {
    let mut remedies = REMEDIES.iter();
    let (_, remedy) = remedies.find(|(names, _)| names.iter().any(|known| known.eq_ignore_ascii_case(name)))?;
    Some(remedy)
}

/// All names of other languages with a VAL 3 equivalent.
pub fn all() -> impl Iterator<Item = &'static str> {
    REMEDIES.iter().flat_map(|(names, _)| names.iter().copied())
}

/// Whether other languages have a field with this name, in upper or lower case, for the number of characters or
/// elements.
#[must_use]
pub fn is_length(field: &str) -> bool {
    ["length", "size", "count", "len"].iter().any(|name| name.eq_ignore_ascii_case(field))
}

/// Names with their VAL 3 equivalent.
const REMEDIES: &[(&[&str], &str)] = &[
    (&["sleep", "waitTime", "pause", "dwell", "waitMs", "wait_time"], "`delay(nSeconds)` waits for a time in seconds"),
    (
        &["print", "printf", "println", "writeln", "console", "echo", "cout"],
        "`putln(…)` writes on the user page, and `?` on the console",
    ),
    (&["str", "itoa", "to_string", "numToStr"], "`toString(\"\",nValue)` makes a string of a number"),
    (
        &["parseFloat", "parseInt", "atoi", "atof", "strToNum", "toNumber"],
        "`toNum(sText,nValue,bReport)` reads a number from a string",
    ),
    (&["int", "trunc", "floor"], "`roundDown(nValue)` rounds down to a whole number"),
    (&["ceil", "ceiling"], "`roundUp(nValue)` rounds up to a whole number"),
    (
        &["getTime", "time", "millis", "now", "timer", "getTickCount"],
        "`clock()` returns the time in seconds, and `getDate(…)` the date",
    ),
    (&["random", "rand", "rnd"], "VAL 3 has no random numbers: compute them, for example from `clock()`"),
    (
        &["sioRead", "sioReceive", "recv", "receive"],
        "`sText=siPort` reads a text from a channel, and `sioGet(siPort,nBytes)` bytes",
    ),
    (&["sioWrite", "sioSend", "send"], "`siPort=sText` sends a text on a channel, and `sioSet(siPort,nBytes)` bytes"),
    (&["mod", "fmod"], "the operator `%` is the remainder: `nA%nB`"),
    (&["pow"], "`power(nBase,nExponent)`"),
    (&["sqr"], "the square is a product: `nA*nA`; `sqrt(nA)` is the square root"),
    (&["atan2"], "`atan(nY/nX)` is between -90 and 90 degrees: add 180 if `nX<0`"),
    (&["sign", "sgn"], "VAL 3 has no function for the sign: compare with `if nValue<0`"),
    (&["shl", "shr", "lshift", "rshift"], "shift bits by a product or a quotient: `nValue*power(2,nBits)`"),
    (&["inc", "incr", "increment"], "`nValue=nValue+1` counts up"),
    (&["dec", "decr", "decrement"], "`nValue=nValue-1` counts down"),
    (&["fabs"], "`abs(nValue)`"),
    (&["sinh", "cosh", "tanh"], "VAL 3 has no hyperbolic functions: compute them with `exp(nValue)`"),
    (&["strlen", "length", "strLength"], "`len(sText)` counts characters, and `size(nArray)` the values of an array"),
    (&["substr", "substring", "strMid"], "`mid(sText,nCount,nIndex)` returns a part of a string"),
    (&["indexOf", "strFind", "instr"], "`find(sText,sPart)` returns the position of a part"),
    (
        &["upper", "lower", "toUpper", "toLower"],
        "VAL 3 has no conversion of letters: compute with their codes `asc(sText,nPosition)` and `chr(nCode)`",
    ),
    (&["concat", "strcat"], "the operator `+` joins strings: `sA+sB`"),
    (
        &["setSpeed", "setVel", "setVelocity", "setOverride", "speedOverride"],
        "`setMonitorSpeed(nPercent)` sets the speed of the arm in per cent",
    ),
    (
        &[
            "set",
            "on",
            "off",
            "reset",
            "setDO",
            "setDIO",
            "setOutput",
            "writeDO",
            "writeOut",
            "digitalWrite",
            "setDout",
            "dOut",
        ],
        "an output is written by assignment: `doName=true`",
    ),
    (
        &["setDI", "setInput", "writeDI"],
        "an input cannot be written; an output is written by assignment: `doName=true`",
    ),
    (
        &["getDI", "getDIO", "getInput", "readDI", "readIn", "digitalRead", "dIn"],
        "an input is read by its name: `if diName==true`",
    ),
    (&["getDO", "getOutput", "readDO"], "an output is read by its name: `if doName==true`"),
    (&["setAO", "analogWrite"], "`aioSet(aoName,nValue)` writes a numerical output"),
    (&["setAI"], "an input cannot be written; `aioSet(aoName,nValue)` writes a numerical output"),
    (&["getAI", "analogRead"], "`aioGet(aiName)` reads a numerical input"),
    (&["getAO"], "`aioGet(aoName)` reads a numerical output"),
    (&["continue"], "VAL 3 has no `continue`: put the rest of the loop into an `if`"),
    (&["null", "none", "nil", "undefined"], "VAL 3 has no empty value: use a `bool` beside the variable"),
    (&["MoveAbsJ", "PTP", "jmove"], "`movej(…)` moves the axes"),
    (&["LIN", "lmove"], "`movel(…)` moves along a line"),
    (&["jog", "jogTo", "moveTo"], "`movej(…)` moves the axes, and `movel(…)` along a line"),
    (&["CIRC"], "`movec(…)` moves along a circle"),
    (&["getJoint", "getJoints", "getJointPos"], "`herej()` returns the position of the axes"),
    (&["getPos", "getPosition", "getPose", "cpos"], "`here(tTool,fFrame)` returns the position of the tool"),
    (
        &["abort", "halt", "exit"],
        "`stopMove()` stops the arm, `taskKill(\"name\")` ends a task, and `return` a program",
    ),
    (&["point", "pointRx", "createPoint"], "a point is a value in braces: `{{x,y,z,rx,ry,rz},{sfree,efree,wfree}}`"),
    (&["lock", "unlock"], "`setMutex(bMutex)` waits until it gets the mutex, and `bMutex=false` releases it"),
    (
        &["taskStart", "startTask", "taskRun", "createTask"],
        "`taskCreate \"name\",100,program()` starts a program as a task",
    ),
    (&["taskStop", "stopTask", "taskEnd", "killTask"], "`taskKill(\"name\")` ends a task"),
    (&["waitDI", "waitDO", "waitUntil", "waitFor"], "`wait(diName==true)` waits for a condition"),
    (&["goto", "jump"], "VAL 3 has no `goto`: use loops and programs"),
    (&["try", "catch", "throw", "raise", "finally"], "VAL 3 has no exceptions: test the results of instructions"),
    (
        &["function", "def", "void", "sub", "proc"],
        "each program has a file of its own; its head is in the XML, and its code between `begin` and `end`",
    ),
    (&["int32", "float", "double", "long", "real"], "numbers have the type `num`"),
    (&["boolean"], "truth values have the type `bool`"),
];

#[cfg(test)]
mod tests {
    use super::REMEDIES;
    use crate::instructions;

    #[test]
    fn no_name_is_an_instruction() {
        for name in REMEDIES.iter().flat_map(|(names, _)| *names) {
            assert!(instructions::find(name).is_none(), "{name}");
        }
    }

    #[test]
    fn no_name_has_two_remedies() {
        let mut names: Vec<String> =
            REMEDIES.iter().flat_map(|(names, _)| *names).map(|name| name.to_lowercase()).collect();
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count);
    }
}
