//! A value as one word of a command line: `1,2,3`, `on`, `buss,rk4`.

use super::field::Kind;
use super::value::{Item, Value, shortened};
use crate::physics::number;

/// Reads the word that stands after a flag.
pub(super) fn read(kind: Kind, word: &str) -> Result<Item, String> {
    let value = match kind {
        Kind::Text | Kind::Choice(_) => Value::Text(word.to_owned()),
        Kind::Number => Value::Number(one_number(word)?),
        Kind::Numbers(count) => Value::List(numbers(count, word)?),
        Kind::Whole | Kind::Axis => {
            let whole = word.trim().parse().map_err(|_| format!("`{}` is not {}", shortened(word), kind.words()))?;
            Value::Whole(whole)
        }
        Kind::Switch => match word {
            "on" => Value::Switch(true),
            "off" => Value::Switch(false),
            _ => return Err(format!("`{}` is neither on nor off", shortened(word))),
        },
        Kind::Names if word.is_empty() => Value::List(vec![]),
        Kind::Names => Value::List(word.split(',').map(|name| Value::Text(name.trim().to_owned()).into()).collect()),
        Kind::Solids => return Err("solids are given by --set body.solids=[…]".to_owned()),
    };
    Ok(value.into())
}

/// Writes the word; nothing where no word reads back to the value.
pub(super) fn write(kind: Kind, value: &Value) -> Option<String> {
    let of_list = |item: &Item| match &item.value {
        Value::Number(value) => Some(number(*value)),
        Value::Text(name) => Some(name.clone()),
        _ => None,
    };
    let word = match value {
        Value::Text(text) => text.clone(),
        Value::Number(value) => number(*value),
        Value::Whole(value) => value.to_string(),
        Value::Switch(is_on) => if *is_on { "on" } else { "off" }.to_owned(),
        Value::List(items) => items.iter().map(of_list).collect::<Option<Vec<_>>>()?.join(","),
        Value::Beyond(_) | Value::Date(_) | Value::Table(_) => return None,
    };
    // A text that begins with a dash would be taken for a flag.
    let is_flag = word.starts_with('-') && matches!(kind, Kind::Text | Kind::Names | Kind::Choice(_));
    (!is_flag && read(kind, &word).is_ok_and(|item| item.value == *value)).then_some(word)
}

fn numbers(count: usize, word: &str) -> Result<Vec<Item>, String> {
    let read = |part| Ok(Value::Number(one_number(part)?).into());
    let numbers: Vec<Item> = word.split(',').map(read).collect::<Result<_, String>>()?;
    match numbers.len() {
        given if given == count => Ok(numbers),
        given => Err(format!("{count} numbers with commas between them are wanted, {given} are given")),
    }
}

fn one_number(word: &str) -> Result<f64, String> {
    let word = word.trim();
    match word.parse::<f64>() {
        // Of letters only infinity itself is infinite.
        Ok(value) if value.is_infinite() && word.contains(|c: char| c.is_ascii_digit()) => {
            Err(format!("`{}` is past the range of numbers", shortened(word)))
        }
        Ok(value) => Ok(value),
        Err(_) => Err(format!("`{}` is not a number", shortened(word))),
    }
}
