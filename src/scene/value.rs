//! A value as TOML has it, with the place where it stands.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::physics::number;

/// Most characters of a text that a message repeats.
const MOST_REPEATED: usize = 40;

/// What stands for a key in a scene file, a flag or a link.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A text.
    Text(String),
    /// A number.
    Number(f64),
    /// A number written without a point.
    Whole(i64),
    /// A number past the range of f64, as it is written.
    Beyond(String),
    /// `true` or `false`.
    Switch(bool),
    /// A date or a time, which no key takes.
    Date(String),
    /// An array.
    List(Vec<Item>),
    /// A table.
    Table(Vec<Entry>),
}

/// A value and where it stands.
#[derive(Clone, Debug)]
pub struct Item {
    /// The value.
    pub value: Value,
    /// First byte of it in its text.
    pub start: usize,
}

/// A key of a table, and what stands for it.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The key.
    pub key: String,
    /// First byte of the key in its text.
    pub start: usize,
    /// Its value.
    pub item: Item,
}

/// Two values are the same wherever they stand.
impl PartialEq for Item {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

/// Wherever they stand.
impl PartialEq for Entry {
    fn eq(&self, other: &Self) -> bool {
        self.key == other.key && self.item == other.item
    }
}

impl From<Value> for Item {
    fn from(value: Value) -> Self {
        Self { value, start: 0 }
    }
}

impl Value {
    /// The value as TOML writes it, on one line.
    #[must_use]
    pub fn to_toml(&self) -> String {
        let list = |parts: Vec<String>| parts.join(", ");
        match self {
            Self::Text(text) => quoted(text),
            Self::Number(value) => number_in_toml(*value),
            Self::Whole(value) => value.to_string(),
            Self::Beyond(text) | Self::Date(text) => text.clone(),
            Self::Switch(is_on) => is_on.to_string(),
            Self::List(items) => format!("[{}]", list(items.iter().map(|item| item.value.to_toml()).collect())),
            Self::Table(entries) => {
                let entry = |entry: &Entry| format!("{} = {}", entry.key, entry.item.value.to_toml());
                format!("{{ {} }}", list(entries.iter().map(entry).collect()))
            }
        }
    }

    /// What it is, in the words of the file: after "is".
    pub(super) fn described(&self) -> String {
        match self {
            Self::Text(text) => format!("the text \"{}\"", shortened(text)),
            Self::Number(value) => format!("the number {}", number(*value)),
            Self::Whole(value) => format!("the number {value}"),
            Self::Beyond(text) => format!("the number {}, past the range of numbers", shortened(text)),
            Self::Switch(is_on) => is_on.to_string(),
            Self::Date(text) => format!("the date {text}"),
            Self::List(items) => format!("an array of {}", items.len()),
            Self::Table(_) => "a table".to_owned(),
        }
    }
}

/// The number as TOML writes it.
fn number_in_toml(value: f64) -> String {
    if value.is_nan() { "nan".to_owned() } else { number(value) }
}

/// A text in quotes on one line, as TOML has it.
fn quoted(text: &str) -> String {
    let mut toml = String::with_capacity(text.len() + 2);
    toml.push('"');
    for character in text.chars() {
        escape(&mut toml, character);
    }
    toml.push('"');
    toml
}

/// Puts a character of a text, escaped where TOML wants it.
pub(super) fn escape(toml: &mut String, character: char) {
    match character {
        '"' => toml.push_str("\\\""),
        '\\' => toml.push_str("\\\\"),
        '\n' => toml.push_str("\\n"),
        '\r' => toml.push_str("\\r"),
        '\t' => toml.push_str("\\t"),
        control if control.is_control() => toml.extend(["\\u", &format!("{:04X}", u32::from(control))]),
        other => toml.push(other),
    }
}

/// A text cut to what a message can hold, on one line.
pub(super) fn shortened(text: &str) -> String {
    let mut short = String::new();
    for character in text.chars().take(MOST_REPEATED) {
        escape(&mut short, if character == '"' { '\'' } else { character });
    }
    if text.chars().nth(MOST_REPEATED).is_some() {
        short.push('…');
    }
    short
}

/// The entries of a table that was read, in the order in which they stand.
pub(super) fn entries(table: &DeTable<'_>) -> Vec<Entry> {
    let mut found: Vec<Entry> = table
        .iter()
        .map(|(key, value)| Entry { key: key.get_ref().to_string(), start: key.span().start, item: item(value) })
        .collect();
    found.sort_by_key(|entry| entry.start);
    found
}

/// A value that was read. How deep arrays and tables can lie in each other is bounded by what reads the text.
fn item(value: &Spanned<DeValue<'_>>) -> Item {
    let start = value.span().start;
    let value = match value.get_ref() {
        DeValue::String(text) => Value::Text(text.to_string()),
        DeValue::Integer(whole) => match i64::from_str_radix(whole.as_str(), whole.radix()) {
            Ok(value) => Value::Whole(value),
            Err(_) if whole.radix() == 10 => in_range(whole.as_str()),
            Err(_) => Value::Beyond(whole.to_string()),
        },
        DeValue::Float(number) => in_range(number.as_str()),
        DeValue::Boolean(is_on) => Value::Switch(*is_on),
        DeValue::Datetime(date) => Value::Date(date.to_string()),
        DeValue::Array(array) => Value::List(array.iter().map(item).collect()),
        DeValue::Table(table) => Value::Table(entries(table)),
    };
    Item { value, start }
}

fn in_range(text: &str) -> Value {
    match text.parse::<f64>() {
        Ok(value) if vanishes(text, value) => Value::Beyond(text.to_owned()),
        Ok(value) if value.is_finite() || text.ends_with("inf") || text.ends_with("nan") => Value::Number(value),
        _ => Value::Beyond(text.to_owned()),
    }
}

/// Whether a number that is not 0 was written and 0 was read: f64 has none as small.
pub(super) fn vanishes(text: &str, value: f64) -> bool {
    let digits = text.split(['e', 'E']).next().unwrap_or_default();
    value == 0.0 && digits.contains(|digit: char| matches!(digit, '1'..='9'))
}

/// The whole number that a number is, however it was written; none where it is no whole one, or none of 64 bits.
pub(super) fn whole_of(value: f64) -> Option<i64> {
    // 2⁶³ itself is one too many.
    let is_whole = value.fract() == 0.0 && value >= i64::MIN as f64 && value < i64::MAX as f64;
    is_whole.then_some(value as i64)
}

#[cfg(test)]
mod tests {
    use super::{Entry, Item, Value, shortened};
    use crate::scene::SceneFile;

    #[test]
    fn values_are_written_as_toml_has_them() {
        let number = |value: f64| Item { value: Value::Number(value), start: 3 };
        let table = Value::Table(vec![
            Entry { key: "a".to_owned(), start: 1, item: number(1.0) },
            Entry { key: "b".to_owned(), start: 2, item: number(-0.0) },
        ]);
        for (value, toml) in [
            (Value::Text("a\"b\\c\n\t\r\u{1}é\u{7f}".to_owned()), r#""a\"b\\c\n\t\r\u0001é\u007F""#),
            (Value::Number(0.1), "0.1"),
            (Value::Number(f64::NAN), "nan"),
            (Value::Number(f64::NEG_INFINITY), "-inf"),
            (Value::Whole(-3), "-3"),
            (Value::Switch(true), "true"),
            (Value::Beyond("1e400".to_owned()), "1e400"),
            (Value::Date("1979-05-27".to_owned()), "1979-05-27"),
            (Value::List(vec![]), "[]"),
            (Value::List(vec![number(1.0), number(2.5)]), "[1, 2.5]"),
            (table, "{ a = 1, b = -0.0 }"),
        ] {
            assert_eq!(value.to_toml(), toml);
        }
    }

    #[test]
    fn values_are_equal_wherever_they_stand() {
        let item = |value, start| Item { value: Value::Whole(value), start };
        assert!(item(1, 2) == item(1, 3) && item(1, 2) != item(2, 2));
        let entry = |key: &str, value| Entry { key: key.to_owned(), start: 0, item: item(value, 0) };
        assert!(entry("a", 1) == Entry { start: 5, ..entry("a", 1) });
        assert!(entry("a", 1) != entry("b", 1) && entry("a", 1) != entry("a", 2));
    }

    #[test]
    fn a_text_is_cut_past_forty_characters() {
        assert_eq!(shortened(&"é".repeat(40)), "é".repeat(40));
        assert_eq!(shortened(&"é".repeat(41)), "é".repeat(40) + "…");
        assert_eq!(shortened("a\"b\nc"), "a'b\\nc");
    }

    #[test]
    fn numbers_of_every_spelling_are_read() {
        for (written, value) in [
            ("1_000", 1000.0),
            ("0xff", 255.0),
            ("0b11", 3.0),
            ("99999999999999999999", 1e20),
            ("-99999999999999999999", -1e20),
            ("+inf", f64::INFINITY),
            ("-1.5e-3", -0.0015),
            ("5e-324", 5e-324),
        ] {
            let file = SceneFile::parse(&format!("spin.rate = {written}"));
            assert_eq!(file.map(|file| file.spin.rate), Ok(Some(value)), "{written}");
        }
        assert!(SceneFile::parse("spin.rate = nan").is_ok_and(|file| file.spin.rate.is_some_and(f64::is_nan)));
        let beyond = "line 1: spin.rate is the number 0xffffffffffffffffff, past the range of numbers: it must be a number (rad/s)";
        let refused = SceneFile::parse("spin.rate = 0xffffffffffffffffff").map_err(|error| error.to_string());
        assert_eq!(refused.err().as_deref(), Some(beyond));
    }
}
