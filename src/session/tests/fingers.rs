//! The panels on screens that fingers touch: what is met is no smaller than a finger, and nothing is out of reach without a keyboard.

use egui::accesskit::{Action, Node, Role};
use egui::{Pos2, RawInput, Rect, Vec2};

use super::Driven;
use crate::scene::SceneError;
use crate::ui::{Command, Front, Panels, style};

/// Least side (points) of what a finger meets.
const FINGER: f64 = 44.0;

/// What is met on a screen of this size, with the commands that pressing each of these names gave, one after the other.
fn shown(driven: &mut Driven, size: Vec2, presses: &[&str]) -> (Vec<Node>, Vec<Command>) {
    let context = egui::Context::default();
    style::install(&context);
    style::for_fingers(&context);
    context.enable_accesskit();
    let mut panels = Panels::default();
    let mut commands = vec![];
    let mut nodes: Vec<(egui::accesskit::NodeId, Node)> = vec![];
    // What opens is there a frame or two later.
    let presses = presses.iter().flat_map(|press| [Some(*press), None, None]);
    for press in [None, None].into_iter().chain(presses) {
        let target = press
            .and_then(|name| nodes.iter().find(|(_, node)| node.label().is_some_and(|label| label.starts_with(name))));
        let request = target.map(|(id, _)| {
            egui::Event::AccessKitActionRequest(egui::accesskit::ActionRequest {
                action: Action::Click,
                target_tree: egui::accesskit::TreeId::ROOT,
                target_node: *id,
                data: None,
            })
        });
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, size)),
            events: request.into_iter().collect(),
            ..RawInput::default()
        };
        let look = driven.session.look(None, false);
        let mut given = vec![];
        let mut output = context.run_ui(input, |ui| given = panels.ui(ui, &look).commands);
        output.textures_delta.clear();
        nodes = output.platform_output.accesskit_update.map_or_else(Vec::new, |tree| tree.nodes);
        for command in given {
            if !matches!(command, Command::Hover(_)) {
                commands.push(command.clone());
            }
            driven.apply(command);
        }
    }
    (nodes.into_iter().map(|(_, node)| node).collect(), commands)
}

/// A session on a page that is touched.
fn touched(name: &str) -> Result<Driven, SceneError> {
    let mut driven = Driven::new(name)?;
    driven.session.shown_by(Front::Page);
    Ok(driven)
}

#[test]
fn what_a_finger_meets_is_no_smaller_than_one() -> Result<(), SceneError> {
    let mut found = vec![];
    for size in [Vec2::new(390.0, 844.0), Vec2::new(844.0, 390.0), Vec2::new(1024.0, 768.0), Vec2::new(768.0, 1024.0)] {
        for presses in [&[][..], &["Methods"][..], &["Picture"][..], &["Picture", "keys"][..]] {
            let mut driven = touched("t-handle")?;
            let (nodes, _) = shown(&mut driven, size, presses);
            // What scrolls is dragged itself, its bar only shows where it is.
            let met: Vec<&Node> = nodes
                .iter()
                .filter(|node| {
                    node.supports_action(Action::Click) && ![Role::Image, Role::ScrollBar].contains(&node.role())
                })
                .collect();
            assert!(met.len() > 15, "{size} {presses:?}: only {} things can be pressed", met.len());
            let small =
                |node: &&Node| node.bounds().is_none_or(|bounds| bounds.width() < FINGER || bounds.height() < FINGER);
            let named = |node: &Node| {
                format!("{:?} “{}” {:?}", node.role(), node.label().or(node.value()).unwrap_or_default(), node.bounds())
            };
            let small: Vec<String> = met.into_iter().filter(small).map(named).collect();
            found.extend(small.into_iter().map(|node| format!("{size} {presses:?}: {node}")));
        }
    }
    assert!(found.is_empty(), "{found:#?}");
    Ok(())
}

#[test]
fn nothing_wants_a_keyboard() -> Result<(), SceneError> {
    let size = Vec2::new(390.0, 844.0);
    let mut closed = touched("t-handle")?;
    closed.apply(Command::TogglePanel);
    let (_, commands) = shown(&mut closed, size, &["About which lines"]);
    assert_eq!(commands, [Command::ToggleAnswer]);
    let (_, commands) = shown(&mut touched("flip")?, size, &["Picture", "keys", "presenter's mode", "write a handout"]);
    assert_eq!(commands, [Command::ToggleHelp, Command::TogglePresenter, Command::Handout]);
    let (_, commands) = shown(&mut touched("flip")?, Vec2::new(1024.0, 768.0), &["the next step or scene"]);
    assert_eq!(commands, [Command::NextStep]);
    Ok(())
}

#[test]
fn the_sheet_of_keys_lies_on_a_screen_in_the_hand() -> Result<(), SceneError> {
    for size in [Vec2::new(390.0, 844.0), Vec2::new(844.0, 390.0), Vec2::new(820.0, 1180.0)] {
        let (nodes, _) = shown(&mut touched("flip")?, size, &["Picture", "keys"]);
        let label = |node: &Node| node.label().or(node.value()).unwrap_or_default().to_owned();
        let beside: Vec<String> = nodes
            .iter()
            .filter(|node| [Role::Button, Role::Label].contains(&node.role()))
            .filter(|node| node.bounds().is_some_and(|bounds| bounds.x0 < 0.0 || bounds.x1 > f64::from(size.x)))
            .map(label)
            .collect();
        assert!(nodes.iter().any(|node| label(node) == "close"), "{size}: it is not open");
        assert!(beside.is_empty(), "{size}: {beside:?} are beside the screen");
    }
    Ok(())
}

#[test]
fn a_finger_leaves_presenters_mode_and_goes_on_in_it() -> Result<(), SceneError> {
    for size in [Vec2::new(390.0, 844.0), Vec2::new(1024.0, 768.0)] {
        let mut driven = touched("flip")?;
        driven.apply(Command::TogglePresenter);
        let (nodes, commands) = shown(&mut driven, size, &["the next step", "the step", "leave presenter's mode"]);
        assert_eq!(commands, [Command::NextStep, Command::PreviousStep, Command::TogglePresenter], "{size}");
        assert!(!driven.session.is_presenting() && !nodes.is_empty());
    }
    Ok(())
}

#[test]
fn the_step_is_said_on_a_tablet() -> Result<(), SceneError> {
    for size in
        [Vec2::new(820.0, 1180.0), Vec2::new(1180.0, 820.0), Vec2::new(744.0, 1133.0), Vec2::new(1600.0, 1000.0)]
    {
        let mut driven = touched("flip")?;
        driven.apply(Command::GoToStep(0));
        let (nodes, _) = shown(&mut driven, size, &[]);
        let step = nodes.iter().find(|node| node.value().is_some_and(|value| value.starts_with("step 1 of ")));
        let bounds = step.and_then(Node::bounds).unwrap_or_default();
        assert!(bounds.height() > 0.0 && bounds.y1 < f64::from(size.y), "{size}: {bounds:?}");
    }
    Ok(())
}
