//! Pages of statements and word operators.

use val3_lang::operators::BinaryOp;
use val3_lang::page;
use val3_lang::statements::{STATEMENTS, Statement};

use super::tables;
use super::topic::{Topic, TopicKind, sourced, stem};

pub(super) fn topics() -> impl Iterator<Item = Topic> {
    STATEMENTS.iter().map(statement)
}

fn statement(row: &Statement) -> Topic {
    let others = row.keywords.iter().filter(|keyword| **keyword != row.name);
    let operator = BinaryOp::from_symbol(row.name);
    let (kind, what) =
        if operator.is_some() { (TopicKind::Operator, "operators") } else { (TopicKind::Statement, "statement") };
    let names: Vec<String> = std::iter::once(&row.name).chain(others).map(|&name| name.to_owned()).collect();
    let title = if operator.is_some() { names.join(", ") } else { row.name.to_owned() };
    let tables = if operator.is_some() { tables::of_operators(&names) } else { String::new() };
    Topic {
        kind,
        group: "",
        stem: stem(row.name),
        summary: page::summary(row.page),
        page: format!("# {title} ({})\n\n{}{tables}", sourced(what, row.section), page::text(row.page)),
        names,
        title,
    }
}
