//! Whether two expressions of a body say the same.

use std::fmt::{Arguments, Write};

use super::{Body, Constant, Expr, ExprId};

impl Body {
    /// Both expressions are written alike, parentheses and ways to write a constant aside. Whether they yield the
    /// same value depends on what happens between them.
    pub fn is_same(&self, left: ExprId, right: ExprId) -> bool {
        self.normal_form(left) == self.normal_form(right)
    }

    /// The expression as text: two expressions have equal texts if and only if they are the same.
    pub fn normal_form(&self, id: ExprId) -> String {
        let mut text = String::new();
        self.write_normal_form(id, &mut text);
        text
    }

    fn write_normal_form(&self, id: ExprId, text: &mut String) {
        match self.constant(id) {
            Some(Constant::Number(number)) => return add(text, format_args!("{number}")),
            Some(Constant::String(string)) => return add(text, format_args!("{string:?}")),
            Some(Constant::Bool(value)) => return add(text, format_args!("{value}")),
            None => {}
        }
        match self.expr(id) {
            Expr::Name(name) => text.push_str(name),
            Expr::Path { library, item } => [library, ":", item].into_iter().for_each(|part| text.push_str(part)),
            Expr::Paren(inner) => self.write_normal_form(*inner, text),
            Expr::Unary(op, operand) => {
                add(text, format_args!("({op:?} "));
                self.write_normal_form(*operand, text);
                text.push(')');
            }
            Expr::Binary(op, left, right) => {
                add(text, format_args!("({op:?} "));
                self.write_list("", &[*left, *right], text);
            }
            Expr::Assign(target, value) => self.write_list("(= ", &[*target, *value], text),
            Expr::Index(base, keys) => {
                self.write_normal_form(*base, text);
                self.write_list("[", keys, text);
            }
            Expr::Field { base, field, .. } => {
                self.write_normal_form(*base, text);
                text.push('.');
                text.push_str(field);
            }
            Expr::Call(callee, args) => {
                self.write_normal_form(*callee, text);
                self.write_list("(", args, text);
            }
            Expr::Struct(values) => {
                text.push('{');
                for value in values {
                    value.iter().for_each(|value| self.write_normal_form(*value, text));
                    text.push(',');
                }
                text.push('}');
            }
            // An unreadable part is equal to no other.
            Expr::Missing | Expr::Number(_) | Expr::String(_) | Expr::Bool(_) => add(text, format_args!("?{}", id.0)),
        }
    }

    fn write_list(&self, open: &str, parts: &[ExprId], text: &mut String) {
        text.push_str(open);
        for part in parts {
            self.write_normal_form(*part, text);
            text.push(',');
        }
        text.push(')');
    }
}

fn add(text: &mut String, part: Arguments<'_>) {
    // Writing to a string cannot fail.
    let _ = text.write_fmt(part);
}
