//! Statements: the mixture of real programs, and the control structures.

use super::body::Body;
use super::model::{Container, Parameter, Signature, Type};

/// Largest nesting of blocks.
const DEEPEST: usize = 4;

/// Counters of `for`, by depth of the block.
const COUNTERS: &[&str] = &["l_i", "l_j", "l_k"];

type Writer = for<'a, 'b> fn(&'a mut Body<'b>);

impl Body<'_> {
    /// Generates some statements.
    pub(super) fn block(&mut self, most: usize) {
        for _ in 0..self.random.between(1, most) {
            self.statement();
        }
    }

    /// Generates a statement, with a comment above it in some cases.
    pub(super) fn statement(&mut self) {
        const ALL: &[(usize, Writer)] = &[
            (155, |body| body.assignment()),
            (90, |body| body.call()),
            (105, |body| body.instruction()),
            (57, |body| body.if_statement()),
            (9, |body| body.for_loop()),
            (4, |body| body.while_loop()),
            (3, |body| body.do_loop()),
            (6, |body| body.switch()),
        ];
        const FLAT: usize = 3;
        self.remark();
        let choices = if self.depth() < DEEPEST { ALL } else { ALL.get(..FLAT).unwrap_or(ALL) };
        if let Some(write) = self.random.weighted(choices) {
            write(self);
        }
    }

    fn if_statement(&mut self) {
        let condition = self.expression(Type::Bool);
        if self.random.chance(20) {
            self.line(format!("if ({condition})"));
        } else {
            self.line(format!("if {condition}"));
        }
        self.deeper(|body| body.block(3));
        if self.random.chance(7) {
            let condition = self.expression(Type::Bool);
            self.line(format!("elseIf {condition}"));
            self.deeper(|body| body.block(2));
        }
        if self.random.chance(30) {
            self.line("else");
            self.deeper(|body| body.block(2));
        }
        self.line("endIf");
    }

    fn for_loop(&mut self) {
        let free = COUNTERS.iter().find(|counter| !self.scope.has_counter(counter));
        let Some(counter) = free else { return self.assignment() };
        self.note((*counter).to_owned());
        let last = self.random.between(1, 2);
        let step = if self.random.chance(8) { " step 1" } else { "" };
        self.line(format!("for {counter}=0 to {last}{step}"));
        self.scope.push_counter(counter);
        self.deeper(|body| body.block(4));
        self.scope.pop_counter();
        self.line("endFor");
    }

    fn while_loop(&mut self) {
        let condition = self.expression(Type::Bool);
        self.line(format!("while {condition}"));
        self.deeper(|body| {
            body.block(4);
            body.line("delay(0)");
        });
        self.line("endWhile");
    }

    fn do_loop(&mut self) {
        self.line("do");
        self.deeper(|body| body.block(4));
        let condition = self.expression(Type::Bool);
        self.line(format!("until {condition}"));
    }

    fn switch(&mut self) {
        let by_text = self.random.chance(10);
        let selector = self.read(if by_text { Type::Text } else { Type::Num });
        self.line(format!("switch {selector}"));
        self.deeper(|body| {
            for label in 0..body.random.between(2, 10) {
                body.case(label, by_text);
            }
            if body.random.chance(33) {
                body.clause("default");
            }
        });
        self.line("endSwitch");
    }

    fn case(&mut self, label: usize, by_text: bool) {
        let head = match by_text {
            true => format!("case \"{label}\""),
            false if self.random.chance(4) => format!("case {},{}", label * 10, label * 10 + 1),
            false => format!("case {}", label * 10),
        };
        self.clause(&head);
    }

    fn clause(&mut self, head: &str) {
        self.line(head);
        self.deeper(|body| body.block(3));
        self.line("break");
    }

    /// Generates the `call` of a program in the application or a library.
    pub(super) fn call(&mut self) {
        let Some(callee) = self.random.pick(self.callees) else { return self.assignment() };
        match self.arguments(callee) {
            Some(arguments) => self.line(format!("call {}({})", callee.name, arguments.join(","))),
            None => self.assignment(),
        }
    }

    /// Returns an argument for each parameter; `None` if the program has no variable to pass.
    fn arguments(&mut self, callee: &Signature) -> Option<Vec<String>> {
        callee.parameters.iter().map(|parameter| self.argument(parameter)).collect()
    }

    fn argument(&mut self, parameter: &Parameter) -> Option<String> {
        let ty = parameter.variable.ty;
        if matches!(parameter.variable.container, Container::Array(_)) {
            return self.scope.array(ty, self.random).map(|array| self.note(array));
        }
        if parameter.by_reference {
            return self.scope.reference(ty, self.random).map(|place| self.note(place));
        }
        Some(self.expression(ty))
    }
}
