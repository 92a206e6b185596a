//! Attributes that a start tag does not contain yet.

use val3_lang::file_pages;
use val3_lang::files::{self, AttributePage, Presence};
use val3_lang::types::{self, AttributeValue};

use super::keys::initial;
use super::snippet::Snippet;
use crate::completion::list::{CompletionKind as Kind, CompletionList};
use crate::declare::old_data;
use crate::hover;
use crate::xml_context::XmlContext;

/// Score bonus of required attributes, and of attributes that every writer adds.
const REQUIRED: i32 = 60;
const EXPECTED: i32 = 30;

/// Missing attributes, required attributes first.
pub(super) fn attributes(found: &mut CompletionList<'_>, context: &XmlContext<'_>) {
    let Some(tag) = &context.cursor.tag else { return };
    let known = files::find(context.file, tag.name);
    let attributes = known.map_or(&[][..], |known| known.attributes);
    for (place, attribute) in (0..).zip(attributes) {
        let score = match attribute.presence {
            Presence::Required => REQUIRED,
            Presence::Expected(_) => EXPECTED,
            Presence::Optional(_) => 0,
        };
        let mut snippet = Snippet::default();
        snippet.attribute(attribute, None);
        let page = file_pages::attribute(context.file, tag.name, attribute.name).map(str::to_owned);
        add(
            found,
            context,
            Offer { name: attribute.name, detail: detail(attribute), snippet, page, score: score - place },
        );
    }
    if let Some(namespace) = known.and_then(|known| known.namespace) {
        let mut snippet = Snippet::default();
        snippet.push(&format!("xmlns=\"{namespace}\""));
        let page = file_pages::attribute(context.file, tag.name, "xmlns").map(str::to_owned);
        add(found, context, Offer { name: "xmlns", detail: "namespace".to_owned(), snippet, page, score: EXPECTED });
    }
    if tag.name == "Value" {
        of_value(found, context);
    }
    of_old_data(found, context);
}

fn detail(attribute: &AttributePage) -> String {
    match attribute.presence {
        Presence::Required => "required".to_owned(),
        Presence::Expected(default) => format!("always written, `{default}` by default"),
        Presence::Optional("") => "optional, empty by default".to_owned(),
        Presence::Optional(default) => format!("optional, `{default}` by default"),
    }
}

/// Value attributes for the surrounding type.
fn of_value(found: &mut CompletionList<'_>, context: &XmlContext<'_>) {
    let (db, project) = (found.db, found.project);
    let Some((ty, arm)) = context.builtin(db, project) else { return };
    for (place, attribute) in (0..).zip(types::attributes(ty, arm)) {
        let default = initial(attribute);
        let mut snippet = Snippet::default();
        snippet.push(&format!("{}=\"", attribute.name));
        snippet.place(&default);
        snippet.push("\"");
        let is_father = matches!(attribute.value, AttributeValue::Father(_));
        let detail = if is_father { "always written".to_owned() } else { format!("`{default}` by default") };
        let page = hover::value_attribute(db, project, ty, arm, attribute.name);
        let score = if is_father { EXPECTED } else { -place };
        add(found, context, Offer { name: attribute.name, detail, snippet, page, score });
    }
}

/// Attributes in data of s5 and s6, which contain all attributes.
fn of_old_data(found: &mut CompletionList<'_>, context: &XmlContext<'_>) {
    let (Some(tag), Some(ty)) = (&context.cursor.tag, context.types().next()) else { return };
    if context.cursor.open.first().is_none_or(|root| root.name != "dataList") {
        return;
    }
    for (place, (name, default)) in (0..).zip(old_data::attributes(ty, tag.name)) {
        let mut snippet = Snippet::default();
        snippet.push(&format!("{name}=\""));
        snippet.place(&default);
        snippet.push("\"");
        let page = file_pages::attribute(context.file, tag.name, &name).map(str::to_owned);
        add(found, context, Offer { name: &name, detail: "always written".to_owned(), snippet, page, score: -place });
    }
}

/// An attribute that can be added.
struct Offer<'o> {
    name: &'o str,
    detail: String,
    snippet: Snippet,
    page: Option<String>,
    score: i32,
}

fn add(found: &mut CompletionList<'_>, context: &XmlContext<'_>, offer: Offer<'_>) {
    let is_there = context.cursor.tag.as_ref().is_some_and(|tag| tag.value(offer.name).is_some());
    if is_there || found.items.iter().any(|item| item.label == offer.name) {
        return;
    }
    let has_value = found.is_before("=");
    let added = found.add(offer.name, Kind::Attribute).detail(|| offer.detail).scored(offer.score);
    added.with(|item| {
        item.documentation = offer.page;
        if !has_value {
            item.insert = offer.snippet.text;
            item.plain = offer.snippet.plain;
            item.is_snippet = true;
        }
    });
}
