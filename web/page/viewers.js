// Who else is looking, and following one of them.

import {byId, h} from './dom.js';

export class Viewers {
  #session;

  constructor(session) {
    this.#session = session;
    session.on('status', () => this.#show()).on('following', () => this.#show());
    byId('follow-stop').addEventListener('click', () => session.follow(0));
  }

  #nameOf(viewer) {
    const name = this.#session.state?.viewers?.find((one) => one.viewer === viewer)?.name;
    return name && name !== 'page' ? `${name} (${viewer})` : `Viewer ${viewer}`;
  }

  #show() {
    const {state, welcome, following, link} = this.#session, viewers = link === 'open' ? state?.viewers ?? [] : [];
    const others = viewers.filter((one) => one.viewer !== welcome?.viewer), button = byId('viewers-button');
    button.hidden = others.length === 0;
    byId('viewers-count').textContent = String(viewers.length);
    button.setAttribute('aria-label', `${viewers.length} viewers`);
    byId('viewers-list').replaceChildren(...others.map((one) => {
      const isFollowed = one.viewer === following;
      const item = h('button', {type: 'button', role: 'menuitemradio', 'aria-checked': String(isFollowed)},
                     h('span', {}, this.#nameOf(one.viewer)), h('small', {}, isFollowed ? 'Following' : 'Follow'));
      item.addEventListener('click', () => {
        this.#session.follow(isFollowed ? 0 : one.viewer);
        byId('viewers-menu').hidePopover();
      });
      return item;
    }));
    const isFollowing = following !== 0, isGone = isFollowing && !others.some((one) => one.viewer === following);
    if (isGone && link === 'open') return this.#session.follow(0);
    byId('following').hidden = !isFollowing;
    if (isFollowing) byId('following-name').textContent = `Following ${this.#nameOf(following)}`;
  }
}
