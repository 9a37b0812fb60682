//! The page's program: a browser starts it when the page is loaded.

fn main() {
    dzhanibekov::web::start();
}
