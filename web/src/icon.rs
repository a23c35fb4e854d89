//! The icons of the design, by their names in `static/icons.svg`.

use yew::prelude::*;

/// Which icon.
#[derive(Clone, PartialEq, Eq, Properties)]
pub struct IconProps {
    /// Its name without the `i-` before it.
    pub name: AttrValue,
    /// More classes.
    #[prop_or_default]
    pub class: Classes,
}

/// An icon. It is silent: the control that holds it has the name.
#[component]
pub fn Icon(props: &IconProps) -> Html {
    html! {
        <svg class={classes!("icon", props.class.clone())} aria-hidden="true">
            <use href={format!("static/icons.svg#i-{}", props.name)} />
        </svg>
    }
}
