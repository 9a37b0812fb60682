//! The panels once more, as the page's own elements: for those who read by ear, and for the keyboard alone.
//!
//! The panels tell what they are by the tree that screen readers get from the window too; whatever is added there is here by itself.

use std::collections::hash_map::Entry;
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use egui::accesskit::{Action, ActionData, ActionRequest, Node, NodeId, Role, Toggled, TreeId, TreeUpdate};
use wasm_bindgen::JsCast;
use web_sys::{Element, Event, HtmlElement, HtmlInputElement, Node as DomNode};

use super::dom;
use super::inbox::{Happening, Inbox};

/// How long (ms) the mirror may lie behind while time runs: what is read aloud is not read faster.
pub(super) const PAUSE: f64 = 500.0;

/// What an element of the page is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// Words.
    Text,
    /// A button; one that holds a state is pressed or not.
    Button,
    /// A box to be ticked.
    Tick,
    /// A number that is slid.
    Slider,
    /// A number that is typed.
    Number,
    /// A picture.
    Image,
}

/// An element as it should be.
#[derive(Clone, Debug, PartialEq)]
struct Part {
    id: NodeId,
    kind: Kind,
    label: String,
    number: Option<[f64; 4]>,
    is_on: Option<bool>,
    is_enabled: bool,
}

/// The elements as they are.
#[derive(Debug, Default)]
pub(super) struct Mirror {
    parts: Vec<Part>,
    elements: HashMap<NodeId, HtmlElement>,
    /// When it was brought up to date (ms).
    updated: f64,
    said: String,
}

impl Mirror {
    /// Whether it is to be brought up to date.
    pub(super) fn is_due(&self, now: f64, is_playing: bool) -> bool {
        !is_playing || now >= self.updated + PAUSE
    }

    /// Brings the page's elements up to date.
    pub(super) fn update(&mut self, tree: &TreeUpdate, inbox: &Rc<Inbox>, now: f64) {
        self.updated = now;
        let parts = parts(tree);
        if parts == self.parts {
            return;
        }
        let Some(root) = dom::element::<HtmlElement>("mirror") else { return };
        let was: HashMap<NodeId, &Part> = self.parts.iter().map(|part| (part.id, part)).collect();
        // Where each stands: only what is out of its place is moved, since what moves loses the keyboard.
        let mut place = root.first_child();
        for part in &parts {
            let old = was.get(&part.id).filter(|old| old.kind == part.kind);
            if old.is_none()
                && let Some(element) = self.elements.remove(&part.id)
            {
                if place.as_ref() == Some(element.unchecked_ref::<DomNode>()) {
                    place = element.next_sibling();
                }
                element.remove();
            }
            let element = match self.elements.entry(part.id) {
                Entry::Occupied(here) => here.into_mut(),
                Entry::Vacant(place) => {
                    let Some(element) = made(part, inbox) else { continue };
                    place.insert(element)
                }
            };
            if old != Some(&part) {
                fill(element, part, old.copied());
            }
            if place.as_ref() == Some(element.unchecked_ref::<DomNode>()) {
                place = element.next_sibling();
            } else {
                // Refused only for a place that is no child.
                let _ = root.insert_before(element, place.as_ref());
            }
        }
        let here: HashSet<NodeId> = parts.iter().map(|part| part.id).collect();
        self.elements.retain(|id, element| {
            let stays = here.contains(id);
            if !stays {
                element.remove();
            }
            stays
        });
        self.parts = parts;
    }

    /// Has a message read aloud, once.
    pub(super) fn say(&mut self, message: &str) {
        if message != self.said {
            message.clone_into(&mut self.said);
            tell(message);
        }
    }
}

/// Has a sentence read aloud.
pub(super) fn tell(sentence: &str) {
    if let Some(live) = dom::element::<Element>("live") {
        live.set_text_content(Some(sentence));
    }
}

/// What a tree comes to, in its order.
fn parts(tree: &TreeUpdate) -> Vec<Part> {
    let nodes: HashMap<NodeId, &Node> = tree.nodes.iter().map(|(id, node)| (*id, node)).collect();
    let root = tree.tree.as_ref().map(|tree| tree.root).or(tree.nodes.first().map(|(id, _)| *id));
    let mut parts = vec![];
    let mut names = vec![];
    let mut left: Vec<NodeId> = root.into_iter().collect();
    while let Some(id) = left.pop() {
        let Some(node) = nodes.get(&id) else { continue };
        names.extend(node.labelled_by());
        if let Some(part) = part(id, node, &nodes) {
            parts.push(part);
            // What a control is made of says the same again.
            continue;
        }
        left.extend(node.children().iter().rev());
    }
    // What only names something else is read with it.
    parts.retain(|part| part.kind != Kind::Text || !names.contains(&part.id));
    parts
}

fn part(id: NodeId, node: &Node, nodes: &HashMap<NodeId, &Node>) -> Option<Part> {
    let kind = match node.role() {
        Role::Label => Kind::Text,
        Role::Button | Role::ComboBox | Role::RadioButton | Role::Link => Kind::Button,
        Role::CheckBox => Kind::Tick,
        Role::Slider => Kind::Slider,
        Role::SpinButton => Kind::Number,
        Role::Image => Kind::Image,
        _ => return None,
    };
    let named = || node.labelled_by().iter().filter_map(|id| nodes.get(id)?.value()).collect::<Vec<_>>().join(" ");
    let label = node.label().map(str::to_owned).filter(|label| !label.is_empty()).unwrap_or_else(named);
    let label = match (kind, node.value()) {
        (Kind::Text, Some(value)) => value.to_owned(),
        (Kind::Button, Some(value)) if label.is_empty() => value.to_owned(),
        _ => label,
    };
    if label.trim().is_empty() && kind != Kind::Slider && kind != Kind::Number {
        return None;
    }
    let number = node.numeric_value().map(|value| {
        let low = node.min_numeric_value().unwrap_or(f64::MIN);
        let high = node.max_numeric_value().unwrap_or(f64::MAX);
        [value, low, high, node.numeric_value_step().unwrap_or(0.0)]
    });
    let is_on = node.toggled().map(|toggled| toggled == Toggled::True);
    Some(Part { id, kind, label, number, is_on, is_enabled: !node.is_disabled() })
}

/// A new element that tells the panels what is asked of it.
fn made(part: &Part, inbox: &Rc<Inbox>) -> Option<HtmlElement> {
    let id = part.id;
    let ask = move |inbox: &Inbox, action: Action, data: Option<ActionData>| {
        let request = ActionRequest { action, target_tree: TreeId::ROOT, target_node: id, data };
        inbox.put(Happening::Event(egui::Event::AccessKitActionRequest(request)));
    };
    let input = |kind: &str| {
        let input = dom::made::<HtmlInputElement>("input")?;
        input.set_type(kind);
        Some(input)
    };
    let element: HtmlElement = match part.kind {
        Kind::Text => return dom::made("p"),
        Kind::Image => {
            let image: HtmlElement = dom::made("div")?;
            let _ = image.set_attribute("role", "img");
            return Some(image);
        }
        Kind::Button => {
            let button: HtmlElement = dom::made("button")?;
            let _ = button.set_attribute("type", "button");
            let to = Rc::clone(inbox);
            dom::listen(&button, "click", move |_: Event| ask(&to, Action::Click, None));
            button
        }
        Kind::Tick => {
            let tick = input("checkbox")?;
            let to = Rc::clone(inbox);
            dom::listen(&tick, "change", move |_: Event| ask(&to, Action::Click, None));
            tick.into()
        }
        Kind::Slider | Kind::Number => {
            let (kind, name) = if part.kind == Kind::Slider { ("range", "input") } else { ("number", "change") };
            let number = input(kind)?;
            let _ = number.set_attribute("step", "any");
            let (to, own) = (Rc::clone(inbox), number.clone());
            dom::listen(&number, name, move |_: Event| {
                let value = own.value_as_number();
                if value.is_finite() {
                    ask(&to, Action::SetValue, Some(ActionData::NumericValue(value)));
                }
            });
            number.into()
        }
    };
    // The panels show a ring round what has the keyboard here; a number would open there for typing.
    if part.kind != Kind::Number {
        let to = Rc::clone(inbox);
        dom::listen(&element, "focus", move |_: Event| ask(&to, Action::Focus, None));
        let to = Rc::clone(inbox);
        dom::listen(&element, "blur", move |_: Event| to.put(Happening::LetGo));
    }
    Some(element)
}

/// Brings an element up to date; only what is another one is set.
fn fill(element: &HtmlElement, part: &Part, old: Option<&Part>) {
    let set = |name: &str, value: &str| {
        let _ = element.set_attribute(name, value);
    };
    if old.is_none_or(|old| old.label != part.label) {
        match part.kind {
            Kind::Text | Kind::Button => element.set_text_content(Some(&part.label)),
            _ => set("aria-label", &part.label),
        }
    }
    if let Some(is_on) = part.is_on {
        match part.kind {
            Kind::Tick => element.unchecked_ref::<HtmlInputElement>().set_checked(is_on),
            _ => set("aria-pressed", if is_on { "true" } else { "false" }),
        }
    }
    if part.kind != Kind::Text && part.kind != Kind::Image {
        let _ = element.toggle_attribute_with_force("disabled", !part.is_enabled);
    }
    let has_keyboard = dom::document().and_then(|document| document.active_element()).as_ref() == Some(element);
    if let Some([value, low, high, step]) = part.number {
        for (name, value) in [("min", low), ("max", high)] {
            if value.abs() < f64::MAX {
                set(name, &value.to_string());
            }
        }
        if step > 0.0 && part.kind == Kind::Slider {
            set("step", &step.to_string());
        }
        // Not while someone types in it.
        if part.kind == Kind::Slider || !has_keyboard {
            element.unchecked_ref::<HtmlInputElement>().set_value(&value.to_string());
        }
    }
}
