//! Programs without faults that terminate, and print the results.
//!
//! Loops count a local that no other statement changes. `start` calls `middle` and `inner`, `middle` calls `inner`, so
//! that no program calls itself.

use std::fmt::Write as _;

use super::choices::Choices;

/// Largest nesting of blocks.
const BLOCKS: usize = 2;
/// Largest nesting of expressions.
const OPERATORS: usize = 3;

const NUMBERS: [&str; 3] = ["nA", "nB", "nC"];
const BOOLS: [&str; 3] = ["bA", "bB", "bC"];
const STRINGS: [&str; 2] = ["sA", "sB"];

const HEAD: &str = "\
num nA = 5
num nB = 2
num nC = 0
num nStep = 0
num nList[3]
bool bA = true
bool bB = false
bool bC = true
string sA = \"x\"
string sB = \"\"

program say(string x_s, num& x_n)
begin
  nStep=nStep+1
  x_n=x_n+nStep
  ?x_s
  ?x_n
end
";

const TAIL: &str = "  ?nA\n  ?nB\n  ?nC\n  ?nStep\n  ?nList[1]\n  ?bA\n  ?bB\n  ?bC\n  ?sA\n  ?sB\n";

/// Returns an application's listing.
pub(super) fn listing(choices: &mut Choices<'_>) -> String {
    let mut writer = Writer { choices, text: HEAD.to_owned(), programs: &[], params: &[], loops: 0 };
    let params: [&str; 2] = ["x_a", "x_b"];
    writer.program("inner(num x_a, num& x_b)", &[], &params, "");
    writer.program("middle(num x_a, num& x_b)", &["inner"], &params, "");
    writer.program("start()", &["inner", "middle"], &[], TAIL);
    writer.text
}

struct Writer<'c, 'b> {
    choices: &'c mut Choices<'b>,
    text: String,
    /// Programs that the present program may call.
    programs: &'static [&'static str],
    /// Parameter names of the present program.
    params: &'c [&'static str],
    /// Number of counters in use.
    loops: usize,
}

impl<'c> Writer<'c, '_> {
    fn program(&mut self, head: &str, programs: &'static [&'static str], params: &'c [&'static str], tail: &str) {
        (self.programs, self.params) = (programs, params);
        let locals = "  num l_nRound0\n  num l_nRound1\n  num l_nRound2\n  num l_n\n  bool l_b\n  string l_s\n";
        _ = write!(self.text, "\nprogram {head}\n{locals}begin\n  l_n=3\n  l_b=false\n  l_s=\"l\"\n");
        let count = 2 + self.choices.below(4);
        self.block(count, 0);
        self.text += tail;
        self.text += "end\n";
    }

    fn line(&mut self, depth: usize, text: &str) {
        _ = writeln!(self.text, "{}{text}", "  ".repeat(depth + 1));
    }

    fn block(&mut self, count: usize, depth: usize) {
        for _ in 0..count {
            self.statement(depth);
        }
    }

    /// Writes a block in a branch or loop, which may be empty.
    fn inner_block(&mut self, depth: usize) {
        let count = self.choices.below(4);
        self.block(count, depth + 1);
    }

    fn statement(&mut self, depth: usize) {
        let kinds = if depth < BLOCKS { 13 } else { 8 };
        match self.choices.below(kinds) {
            0 | 1 => self.assign_number(depth),
            2 => {
                let (name, value) = (self.bool_name(), self.bool(0));
                self.line(depth, &format!("{name}={value}"));
            }
            3 => {
                let (name, value) = (self.string_name(), self.string(0));
                self.line(depth, &format!("{name}={value}"));
            }
            4 => {
                let value = self.any_value();
                self.line(depth, &format!("?{value}"));
            }
            5 => self.call(depth),
            6 => {
                let text = self.choices.one_of(&["// why", "", "// if it is so"]);
                self.line(depth, text);
            }
            7 => {
                let (index, value) = (self.choices.below(3), self.number(0));
                self.line(depth, &format!("nList[{index}]={value}"));
            }
            8 | 9 => self.if_statement(depth),
            10 => self.switch(depth),
            11 => self.for_loop(depth),
            _ => self.while_loop(depth),
        }
    }

    fn assign_number(&mut self, depth: usize) {
        let (name, value) = (self.number_name(), self.number(0));
        self.line(depth, &format!("{name}={value}"));
    }

    fn call(&mut self, depth: usize) {
        let name = self.number_name();
        match self.choices.below(self.programs.len() + 1) {
            0 => {
                let text = self.string(1);
                self.line(depth, &format!("call say({text},{name})"));
            }
            at => {
                let (program, value) = (self.programs[at - 1], self.number(1));
                self.line(depth, &format!("call {program}({value},{name})"));
            }
        }
    }

    fn if_statement(&mut self, depth: usize) {
        let condition = self.bool(0);
        self.line(depth, &format!("if {condition}"));
        self.inner_block(depth);
        while self.choices.once_in(3) {
            let condition = self.bool(0);
            self.line(depth, &format!("elseIf {condition}"));
            self.inner_block(depth);
        }
        if self.choices.below(2) == 1 {
            self.line(depth, "else");
            self.inner_block(depth);
        }
        self.line(depth, "endIf");
    }

    fn switch(&mut self, depth: usize) {
        let kind = self.choices.below(3);
        let selector = self.value_of(kind);
        self.line(depth, &format!("switch {selector}"));
        for _ in 0..=self.choices.below(3) {
            let mut values = self.value_of(kind);
            while self.choices.once_in(3) {
                values = format!("{values},{}", self.value_of(kind));
            }
            self.line(depth + 1, &format!("case {values}"));
            self.inner_block(depth + 1);
            self.line(depth + 1, "break");
        }
        if self.choices.below(2) == 1 {
            self.line(depth + 1, "default");
            self.inner_block(depth + 1);
            self.line(depth + 1, "break");
        }
        self.line(depth, "endSwitch");
    }

    fn for_loop(&mut self, depth: usize) {
        let Some(counter) = self.counter() else { return self.assign_number(depth) };
        let (first, last) = (self.choices.below(3), self.choices.below(4));
        self.line(depth, &format!("for {counter}={first} to {last}"));
        self.inner_block(depth);
        self.line(depth, "endFor");
        self.loops -= 1;
    }

    fn while_loop(&mut self, depth: usize) {
        let Some(counter) = self.counter() else { return self.assign_number(depth) };
        let also = if self.choices.below(2) == 1 { format!(" and {}", self.operand_of_and()) } else { String::new() };
        self.line(depth, &format!("{counter}=0"));
        let is_until = self.choices.below(3) == 2;
        if is_until {
            self.line(depth, "do");
        } else {
            self.line(depth, &format!("while {counter}<3{also}"));
        }
        self.line(depth + 1, &format!("{counter}={counter}+1"));
        self.inner_block(depth);
        self.line(depth, &if is_until { format!("until {counter}>2") } else { "endWhile".to_owned() });
        self.loops -= 1;
    }

    /// Returns the name of a counter that no enclosing loop uses.
    fn counter(&mut self) -> Option<String> {
        let number = self.loops;
        (number < 3).then(|| {
            self.loops += 1;
            format!("l_nRound{number}")
        })
    }

    fn operand_of_and(&mut self) -> String {
        let value = self.bool(1);
        if value.contains(' ') { format!("({value})") } else { value }
    }

    fn number_name(&mut self) -> &'static str {
        match self.choices.below(NUMBERS.len() + 2) {
            3 => "l_n",
            4 => self.params.get(1).copied().unwrap_or("nA"),
            at => NUMBERS[at],
        }
    }

    fn bool_name(&mut self) -> &'static str {
        let at = self.choices.below(BOOLS.len() + 1);
        BOOLS.get(at).copied().unwrap_or("l_b")
    }

    fn string_name(&mut self) -> &'static str {
        let at = self.choices.below(STRINGS.len() + 1);
        STRINGS.get(at).copied().unwrap_or("l_s")
    }

    fn any_value(&mut self) -> String {
        let kind = self.choices.below(3);
        self.value_of(kind)
    }

    fn value_of(&mut self, kind: usize) -> String {
        match kind {
            0 => self.number(0),
            1 => self.bool(0),
            _ => self.string(0),
        }
    }

    /// Encloses a value in parentheses in some cases.
    fn perhaps_in_parentheses(&mut self, value: String) -> String {
        if self.choices.once_in(4) { format!("({value})") } else { value }
    }

    fn number(&mut self, depth: usize) -> String {
        let kinds = if depth < OPERATORS { 11 } else { 5 };
        let value = match self.choices.below(kinds) {
            0 | 1 => self.number_name().to_owned(),
            2 | 3 => self.choices.one_of(&["1", "2", "6", "0", "3.5", "10"]).to_owned(),
            4 => format!("nList[{}]", self.choices.below(3)),
            5 => {
                let value = self.number(OPERATORS);
                if value.starts_with('-') { value } else { format!("-{value}") }
            }
            6 => {
                let value = self.number(depth + 1);
                format!("{}({value})", self.choices.one_of(&["abs", "roundUp"]))
            }
            7 => {
                let value = self.string(depth + 1);
                format!("len({value})")
            }
            _ => {
                let (left, right) = (self.factor(depth), self.factor(depth));
                format!("{left}{}{right}", self.choices.one_of(&["+", "-", "*", " / ", " % ", " + "]))
            }
        };
        self.perhaps_in_parentheses(value)
    }

    /// Writes a number as an operand: in parentheses unless it is simple.
    fn factor(&mut self, depth: usize) -> String {
        let value = self.number(depth + 1);
        let is_simple = value.chars().all(|letter| letter.is_alphanumeric() || letter == '_' || letter == '.');
        if is_simple || self.choices.below(3) == 0 && !value.starts_with('-') { value } else { format!("({value})") }
    }

    fn bool(&mut self, depth: usize) -> String {
        let kinds = if depth < OPERATORS { 11 } else { 4 };
        let value = match self.choices.below(kinds) {
            0..=2 => self.bool_name().to_owned(),
            3 => self.choices.one_of(&["true", "false"]).to_owned(),
            4 => {
                let value = self.bool(OPERATORS);
                format!("!{value}")
            }
            5 | 6 => {
                let (left, right) = (self.factor(depth + 1), self.factor(depth + 1));
                format!("{left}{}{right}", self.choices.one_of(&["==", "!=", "<", ">", "<=", ">="]))
            }
            7 => {
                let (left, right) = (self.string(OPERATORS), self.string(OPERATORS));
                format!("{left}{}{right}", self.choices.one_of(&["==", "!="]))
            }
            8 => {
                let (left, right) = (self.bool(OPERATORS), self.bool(OPERATORS));
                format!("{left}{}{right}", self.choices.one_of(&["==", "!="]))
            }
            9 => {
                let (name, result) = (self.number_name(), self.bool_name());
                format!("toNum(\"7 x\",{name},{result})!=\"\"")
            }
            _ => {
                let (left, right) = (self.bool(depth + 1), self.bool(depth + 1));
                format!("{left} {} {right}", self.choices.one_of(&["and", "or", "xor"]))
            }
        };
        self.perhaps_in_parentheses(value)
    }

    fn string(&mut self, depth: usize) -> String {
        let kinds = if depth < OPERATORS { 6 } else { 3 };
        let value = match self.choices.below(kinds) {
            0 | 1 => self.string_name().to_owned(),
            2 => self.choices.one_of(&["\"\"", "\"x\"", "\"ab\"", "\"a b\""]).to_owned(),
            3 => {
                let value = self.number(depth + 1);
                format!("toString(\".2\",{value})")
            }
            _ => {
                let (left, right) = (self.string(depth + 1), self.string(depth + 1));
                format!("{left}+{right}")
            }
        };
        self.perhaps_in_parentheses(value)
    }
}
