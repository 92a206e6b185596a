//! Comparison of expressions by their normal forms.

use std::fmt::{Arguments, Write};

use super::{Body, Constant, Expr, ExprId};

impl Body {
    /// Whether both expressions have the same form, except for parentheses and the spelling of constants. Whether they
    /// yield the same value depends on the code between them.
    pub fn is_same(&self, left: ExprId, right: ExprId) -> bool {
        self.normal_form(left) == self.normal_form(right)
    }

    /// Returns the expression as a string: two expressions have equal strings if and only if they are the same.
    pub fn normal_form(&self, id: ExprId) -> String {
        let mut form = ExpressionForm { body: self, folds_constants: true, text: String::new() };
        form.expr(id);
        form.text
    }

    /// Returns the [`normal_form`](Self::normal_form) with constants as written: `2*3` differs from `6`.
    pub fn written_form(&self, id: ExprId) -> String {
        let mut form = ExpressionForm { body: self, folds_constants: false, text: String::new() };
        form.expr(id);
        form.text
    }
}

struct ExpressionForm<'b> {
    body: &'b Body,
    /// Whether constant expressions are replaced by their values.
    folds_constants: bool,
    text: String,
}

impl ExpressionForm<'_> {
    fn expr(&mut self, id: ExprId) {
        let body = self.body;
        let is_literal = matches!(body.expr(id), Expr::Number(_) | Expr::String(_) | Expr::Bool(_));
        let text = &mut self.text;
        match body.constant(id).filter(|_| self.folds_constants || is_literal) {
            Some(Constant::Number(number)) => return add(text, format_args!("{number}")),
            Some(Constant::String(string)) => return add(text, format_args!("{string:?}")),
            Some(Constant::Bool(value)) => return add(text, format_args!("{value}")),
            None => {}
        }
        match body.expr(id) {
            Expr::Name(name) => self.text.push_str(name),
            Expr::Path { library, item } => [library, ":", item].into_iter().for_each(|part| self.text.push_str(part)),
            Expr::Paren(inner) => self.expr(*inner),
            Expr::Unary(op, operand) => {
                add(&mut self.text, format_args!("({op:?} "));
                self.expr(*operand);
                self.text.push(')');
            }
            Expr::Binary(op, left, right) => {
                add(&mut self.text, format_args!("({op:?} "));
                self.list("", &[*left, *right]);
            }
            Expr::Assign(target, value) => self.list("(= ", &[*target, *value]),
            Expr::Index(base, keys) => {
                self.expr(*base);
                self.list("[", keys);
            }
            Expr::Field { base, field, .. } => {
                self.expr(*base);
                self.text.push('.');
                self.text.push_str(field);
            }
            Expr::Call(callee, args) => {
                self.expr(*callee);
                self.list("(", args);
            }
            Expr::Struct(values) => {
                self.text.push('{');
                for value in values {
                    value.iter().for_each(|value| self.expr(*value));
                    self.text.push(',');
                }
                self.text.push('}');
            }
            // An unreadable part is equal to no other.
            Expr::Missing | Expr::Number(_) | Expr::String(_) | Expr::Bool(_) => {
                add(&mut self.text, format_args!("?{}", id.0))
            }
        }
    }

    fn list(&mut self, open: &str, parts: &[ExprId]) {
        self.text.push_str(open);
        for part in parts {
            self.expr(*part);
            self.text.push(',');
        }
        self.text.push(')');
    }
}

fn add(text: &mut String, part: Arguments<'_>) {
    // Writing to a string cannot fail.
    let _ = text.write_fmt(part);
}
