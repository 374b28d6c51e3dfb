// Starts the mock server by hand: node mock/main.js [PORT]. Ends with the terminal, or after an hour.

import {MockServer} from './server.js';

const server = await new MockServer().start(Number(process.argv[2] ?? 0));
server.withTimes = true;
console.log(server.url);
setTimeout(() => process.exit(0), 3600 * 1000);
