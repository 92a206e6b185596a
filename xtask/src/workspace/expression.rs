//! Expressions of a requested type.

use super::body::Body;
use super::model::Type;
use super::words::TEXTS;

/// Largest depth; deeper expressions are rare in real programs.
const DEEPEST: usize = 2;

impl Body<'_> {
    /// Generates an expression of a type.
    pub(super) fn expression(&mut self, ty: Type) -> String {
        self.value(ty, 0)
    }

    fn value(&mut self, ty: Type, depth: usize) -> String {
        match ty {
            Type::Num => self.number(depth),
            Type::Bool => self.condition(depth),
            Type::Text => self.text(depth),
            Type::Point => self.point(),
            Type::Trsf => self.transformation(),
            other => self.read(other),
        }
    }

    /// Generates the value of a variable.
    pub(super) fn read(&mut self, ty: Type) -> String {
        match self.scope.readable(ty, self.random) {
            Some(place) => self.note(place),
            None => literal(ty).to_owned(),
        }
    }

    fn number(&mut self, depth: usize) -> String {
        if depth >= DEEPEST {
            return self.number_atom();
        }
        match self.random.below(10) {
            0..=5 => self.number_atom(),
            6 => format!("{}({})", self.random.word(&["abs", "roundDown", "sqrt", "sin"]), self.number(depth + 1)),
            7 => format!("{}*{}", self.number_atom(), self.number_literal()),
            8 => format!("({}-{})/{}", self.number_atom(), self.number_literal(), self.number_literal()),
            _ => format!("{}+{}", self.number(depth + 1), self.number_atom()),
        }
    }

    fn number_atom(&mut self) -> String {
        match self.random.below(10) {
            0..=3 => self.number_literal(),
            4 => match self.scope.array(Type::Num, self.random) {
                Some(array) => format!("size({})", self.note(array)),
                None => self.number_literal(),
            },
            _ => self.read(Type::Num),
        }
    }

    /// Generates a positive number.
    fn number_literal(&mut self) -> String {
        let whole = self.random.between(1, 250);
        if self.random.chance(3) { format!("{whole}.5") } else { whole.to_string() }
    }

    fn condition(&mut self, depth: usize) -> String {
        if depth >= DEEPEST {
            return self.comparison();
        }
        match self.random.below(12) {
            0..=4 => self.comparison(),
            5 => self.read(Type::Bool),
            6 => format!("!{}", self.read(Type::Bool)),
            7 => format!("{}=={}", self.read(Type::Dio), self.random.word(&["true", "false"])),
            8 => self.random.word(&["isPowered()", "isEmpty()", "isSettled()", "isCalibrated()"]).to_owned(),
            9 => format!("({}) or ({})", self.condition(depth + 1), self.comparison()),
            _ => format!("({}) and ({})", self.condition(depth + 1), self.comparison()),
        }
    }

    fn comparison(&mut self) -> String {
        if self.random.chance(15) {
            return format!("{}!=\"{}\"", self.read(Type::Text), self.random.word(TEXTS));
        }
        let left = self.read(Type::Num);
        if self.random.chance(30) {
            return format!("{left}{}{}", self.random.word(&["==", "!="]), self.random.between(1, 250));
        }
        let operator = self.random.word(&["<", "<=", ">", ">="]);
        let right = Some(self.number(1)).filter(|right| *right != left).unwrap_or_else(|| self.number_literal());
        format!("{left}{operator}{right}")
    }

    fn text(&mut self, depth: usize) -> String {
        if depth < DEEPEST && self.random.chance(35) {
            return format!("{}+{}", self.text_atom(), self.text(depth + 1));
        }
        self.text_atom()
    }

    fn text_atom(&mut self) -> String {
        match self.random.below(10) {
            0..=4 => format!("\"{}\"", self.random.word(TEXTS)),
            5 => format!("toString(\"{}\",{})", self.random.word(&["", ".2", "7.1"]), self.number(1)),
            6 => format!("left({},{})", self.read(Type::Text), self.random.between(1, 9)),
            _ => self.read(Type::Text),
        }
    }

    fn point(&mut self) -> String {
        let point = self.read(Type::Point);
        if self.random.chance(30) { format!("appro({point},{})", self.transformation()) } else { point }
    }

    fn transformation(&mut self) -> String {
        if self.random.chance(50) {
            return format!("{{0,0,-{},0,0,{}}}", self.random.between(10, 300), self.random.between(0, 90));
        }
        self.read(Type::Trsf)
    }
}

/// Returns a value for a program without a variable of the type.
fn literal(ty: Type) -> &'static str {
    match ty {
        Type::Num => "1",
        Type::Bool => "true",
        Type::Text => "\"\"",
        Type::Frame => "world",
        Type::Tool => "flange",
        _ => "{0,0,0,0,0,0}",
    }
}
