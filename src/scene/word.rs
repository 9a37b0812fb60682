//! A value as one word of a command line: `1,2,3`, `on`, `buss,rk4`.

use super::field::Kind;
use super::value::{Item, Value, shortened, vanishes, whole_of};
use crate::physics::number;

/// Reads the word that stands after a flag.
pub(super) fn read(kind: Kind, word: &str) -> Result<Item, String> {
    let value = match kind {
        Kind::Text | Kind::Choice(_) => Value::Text(word.to_owned()),
        Kind::Number => Value::Number(one_number(word)?),
        Kind::Numbers(count) => Value::List(numbers(count, word)?),
        Kind::Whole | Kind::Axis => whole(word).ok_or_else(|| not_of(kind, word))?,
        Kind::Switch => match word {
            "on" => Value::Switch(true),
            "off" => Value::Switch(false),
            _ => return Err(format!("`{}` is neither on nor off", shortened(word))),
        },
        Kind::Names if word.is_empty() => Value::List(vec![]),
        Kind::Names => Value::List(word.split(',').map(|name| Value::Text(name.trim().to_owned()).into()).collect()),
        Kind::Axes => Value::List(
            word.split(',')
                .map(|part| whole(part).map(Item::from))
                .collect::<Option<_>>()
                .ok_or_else(|| not_of(kind, word))?,
        ),
        Kind::Solids => return Err("solids are given by --set body.solids=[…]".to_owned()),
        Kind::Steps => return Err("steps are given by --set step=[…]".to_owned()),
    };
    Ok(value.into())
}

/// Writes the word; nothing where no word reads back to the value.
pub(super) fn write(kind: Kind, value: &Value) -> Option<String> {
    let of_list = |item: &Item| match &item.value {
        Value::Number(value) => Some(number(*value)),
        Value::Whole(value) => Some(value.to_string()),
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

/// What is said of a word that is not of a kind.
fn not_of(kind: Kind, word: &str) -> String {
    if kind == Kind::Whole && one_number(word).is_ok_and(|value| value.fract() == 0.0) {
        return format!("`{}` is past the range of whole numbers", shortened(word));
    }
    format!("`{}` is not {}", shortened(word), kind.words())
}

/// A whole number, written as one or with a power.
fn whole(word: &str) -> Option<Value> {
    let word = word.trim();
    let written = word.parse().map(Value::Whole).ok();
    written.or_else(|| one_number(word).ok().and_then(whole_of).map(Value::Whole))
}

/// Reads one number, as every flag that takes one does.
///
/// # Errors
/// One sentence: no number, or one that f64 has no place for, as large or as small as it is.
pub fn one_number(word: &str) -> Result<f64, String> {
    let word = word.trim();
    match word.parse::<f64>() {
        // Of letters only infinity itself is infinite.
        Ok(value) if value.is_infinite() && word.contains(|c: char| c.is_ascii_digit()) => {
            Err(format!("`{}` is past the range of numbers", shortened(word)))
        }
        Ok(value) if vanishes(word, value) => {
            Err(format!("`{}` is past the range of numbers: it is nearer to 0 than any but 0 itself", shortened(word)))
        }
        Ok(value) => Ok(value),
        Err(_) => Err(format!("`{}` is not a number", shortened(word))),
    }
}

#[cfg(test)]
mod tests {
    use super::{Kind, Value, read, write};

    #[test]
    fn words_are_read_and_written() -> Result<(), String> {
        let names =
            |names: &[&str]| Value::List(names.iter().map(|name| Value::Text((*name).to_owned()).into()).collect());
        let numbers =
            |numbers: &[f64]| Value::List(numbers.iter().map(|number| Value::Number(*number).into()).collect());
        for (kind, word, value) in [
            (Kind::Text, "buss", Value::Text("buss".to_owned())),
            (Kind::Choice(&["dark"]), "dark", Value::Text("dark".to_owned())),
            (Kind::Number, "-2.5", Value::Number(-2.5)),
            (Kind::Number, "1e-300", Value::Number(1e-300)),
            (Kind::Number, "inf", Value::Number(f64::INFINITY)),
            (Kind::Numbers(3), "1,-2,3e20", numbers(&[1.0, -2.0, 3e20])),
            (Kind::Whole, "-7", Value::Whole(-7)),
            (Kind::Axis, "3", Value::Whole(3)),
            (Kind::Switch, "on", Value::Switch(true)),
            (Kind::Switch, "off", Value::Switch(false)),
            (Kind::Axes, "1,3", Value::List(vec![Value::Whole(1).into(), Value::Whole(3).into()])),
            (Kind::Names, "", names(&[])),
            (Kind::Names, "a", names(&["a"])),
            (Kind::Names, "a,b", names(&["a", "b"])),
        ] {
            assert_eq!(read(kind, word)?.value, value, "{word}");
            assert_eq!(write(kind, &value).as_deref(), Some(word));
        }
        assert_eq!(read(Kind::Numbers(2), " 1 , 2 ")?.value, numbers(&[1.0, 2.0]));
        assert_eq!(read(Kind::Names, "a, b")?.value, names(&["a", "b"]));
        assert!(read(Kind::Number, "nan")?.value != Value::Number(0.0));
        Ok(())
    }

    #[test]
    fn what_no_word_says_is_not_written() {
        let text = |text: &str| Value::Text(text.to_owned());
        assert_eq!(write(Kind::Text, &text("-x")), None);
        assert_eq!(write(Kind::Names, &Value::List(vec![text("-x").into()])), None);
        assert_eq!(write(Kind::Names, &Value::List(vec![text("a,b").into()])), None);
        assert_eq!(write(Kind::Names, &Value::List(vec![text("").into()])), None);
        assert_eq!(write(Kind::Solids, &Value::List(vec![Value::Table(vec![]).into()])), None);
        assert_eq!(write(Kind::Number, &text("x")), None);
        assert_eq!(write(Kind::Text, &Value::Date("1979-05-27".to_owned())), None);
        assert!(read(Kind::Axes, "1,x").is_err_and(|why| why.starts_with("`1,x` is not an array of axes")));
        assert!(read(Kind::Solids, "x").is_err_and(|why| why.contains("--set body.solids")));
        assert!(read(Kind::Numbers(2), "1,2,x").is_err_and(|why| why == "`x` is not a number"));
        assert!(read(Kind::Numbers(2), "-1e999,2").is_err_and(|why| why.contains("past the range")));
        let too_small = "`1e-400` is past the range of numbers: it is nearer to 0 than any but 0 itself";
        assert!(read(Kind::Numbers(2), "1e-400,2").is_err_and(|why| why == too_small));
        assert!(read(Kind::Axis, "2.5").is_err_and(|why| why.starts_with("`2.5` is not 1 (smallest moment)")));
        assert!(read(Kind::Whole, "1e300").is_err_and(|why| why == "`1e300` is past the range of whole numbers"));
    }

    #[test]
    fn whole_numbers_may_have_a_point_or_a_power() -> Result<(), String> {
        assert_eq!(read(Kind::Axis, "2.0")?.value, Value::Whole(2));
        assert_eq!(read(Kind::Whole, "-1e5")?.value, Value::Whole(-100_000));
        assert_eq!(read(Kind::Axes, "1.0,3")?.value, Value::List(vec![Value::Whole(1).into(), Value::Whole(3).into()]));
        for zero in ["0", "-0.0", "0e400", "0.000"] {
            assert!(read(Kind::Number, zero)?.value == Value::Number(0.0), "{zero}");
        }
        Ok(())
    }
}
