"use strict";
(() => {
  var __create = Object.create;
  var __defProp = Object.defineProperty;
  var __getOwnPropDesc = Object.getOwnPropertyDescriptor;
  var __getOwnPropNames = Object.getOwnPropertyNames;
  var __getProtoOf = Object.getPrototypeOf;
  var __hasOwnProp = Object.prototype.hasOwnProperty;
  var __commonJS = (cb, mod) => function __require() {
    try {
      return mod || (0, cb[__getOwnPropNames(cb)[0]])((mod = { exports: {} }).exports, mod), mod.exports;
    } catch (e) {
      throw mod = 0, e;
    }
  };
  var __copyProps = (to, from, except, desc) => {
    if (from && typeof from === "object" || typeof from === "function") {
      for (let key of __getOwnPropNames(from))
        if (!__hasOwnProp.call(to, key) && key !== except)
          __defProp(to, key, { get: () => from[key], enumerable: !(desc = __getOwnPropDesc(from, key)) || desc.enumerable });
    }
    return to;
  };
  var __toESM = (mod, isNodeMode, target2) => (target2 = mod != null ? __create(__getProtoOf(mod)) : {}, __copyProps(
    // If the importer is in node compatibility mode or this is not an ESM
    // file that has been converted to a CommonJS file using a Babel-
    // compatible transform (i.e. "__esModule" has not been set), then set
    // "default" to the CommonJS "module.exports" for node compatibility.
    isNodeMode || !mod || !mod.__esModule ? __defProp(target2, "default", { value: mod, enumerable: true }) : target2,
    mod
  ));

  // node_modules/regenerator-runtime/runtime.js
  var require_runtime = __commonJS({
    "node_modules/regenerator-runtime/runtime.js"(exports, module) {
      var runtime = (function(exports2) {
        "use strict";
        var Op = Object.prototype;
        var hasOwn = Op.hasOwnProperty;
        var defineProperty = Object.defineProperty || function(obj, key, desc) {
          obj[key] = desc.value;
        };
        var undefined2;
        var $Symbol = typeof Symbol === "function" ? Symbol : {};
        var iteratorSymbol = $Symbol.iterator || "@@iterator";
        var asyncIteratorSymbol = $Symbol.asyncIterator || "@@asyncIterator";
        var toStringTagSymbol = $Symbol.toStringTag || "@@toStringTag";
        function define(obj, key, value) {
          Object.defineProperty(obj, key, {
            value,
            enumerable: true,
            configurable: true,
            writable: true
          });
          return obj[key];
        }
        try {
          define({}, "");
        } catch (err) {
          define = function(obj, key, value) {
            return obj[key] = value;
          };
        }
        function wrap(innerFn, outerFn, self, tryLocsList) {
          var protoGenerator = outerFn && outerFn.prototype instanceof Generator ? outerFn : Generator;
          var generator = Object.create(protoGenerator.prototype);
          var context = new Context(tryLocsList || []);
          defineProperty(generator, "_invoke", { value: makeInvokeMethod(innerFn, self, context) });
          return generator;
        }
        exports2.wrap = wrap;
        function tryCatch(fn, obj, arg) {
          try {
            return { type: "normal", arg: fn.call(obj, arg) };
          } catch (err) {
            return { type: "throw", arg: err };
          }
        }
        var GenStateSuspendedStart = "suspendedStart";
        var GenStateSuspendedYield = "suspendedYield";
        var GenStateExecuting = "executing";
        var GenStateCompleted = "completed";
        var ContinueSentinel = {};
        function Generator() {
        }
        function GeneratorFunction() {
        }
        function GeneratorFunctionPrototype() {
        }
        var IteratorPrototype = {};
        define(IteratorPrototype, iteratorSymbol, function() {
          return this;
        });
        var getProto = Object.getPrototypeOf;
        var NativeIteratorPrototype = getProto && getProto(getProto(values([])));
        if (NativeIteratorPrototype && NativeIteratorPrototype !== Op && hasOwn.call(NativeIteratorPrototype, iteratorSymbol)) {
          IteratorPrototype = NativeIteratorPrototype;
        }
        var Gp = GeneratorFunctionPrototype.prototype = Generator.prototype = Object.create(IteratorPrototype);
        GeneratorFunction.prototype = GeneratorFunctionPrototype;
        defineProperty(Gp, "constructor", { value: GeneratorFunctionPrototype, configurable: true });
        defineProperty(
          GeneratorFunctionPrototype,
          "constructor",
          { value: GeneratorFunction, configurable: true }
        );
        GeneratorFunction.displayName = define(
          GeneratorFunctionPrototype,
          toStringTagSymbol,
          "GeneratorFunction"
        );
        function defineIteratorMethods(prototype) {
          ["next", "throw", "return"].forEach(function(method) {
            define(prototype, method, function(arg) {
              return this._invoke(method, arg);
            });
          });
        }
        exports2.isGeneratorFunction = function(genFun) {
          var ctor = typeof genFun === "function" && genFun.constructor;
          return ctor ? ctor === GeneratorFunction || // For the native GeneratorFunction constructor, the best we can
          // do is to check its .name property.
          (ctor.displayName || ctor.name) === "GeneratorFunction" : false;
        };
        exports2.mark = function(genFun) {
          if (Object.setPrototypeOf) {
            Object.setPrototypeOf(genFun, GeneratorFunctionPrototype);
          } else {
            genFun.__proto__ = GeneratorFunctionPrototype;
            define(genFun, toStringTagSymbol, "GeneratorFunction");
          }
          genFun.prototype = Object.create(Gp);
          return genFun;
        };
        exports2.awrap = function(arg) {
          return { __await: arg };
        };
        function AsyncIterator(generator, PromiseImpl) {
          function invoke(method, arg, resolve, reject) {
            var record = tryCatch(generator[method], generator, arg);
            if (record.type === "throw") {
              reject(record.arg);
            } else {
              var result = record.arg;
              var value = result.value;
              if (value && typeof value === "object" && hasOwn.call(value, "__await")) {
                return PromiseImpl.resolve(value.__await).then(function(value2) {
                  invoke("next", value2, resolve, reject);
                }, function(err) {
                  invoke("throw", err, resolve, reject);
                });
              }
              return PromiseImpl.resolve(value).then(function(unwrapped) {
                result.value = unwrapped;
                resolve(result);
              }, function(error) {
                return invoke("throw", error, resolve, reject);
              });
            }
          }
          var previousPromise;
          function enqueue(method, arg) {
            function callInvokeWithMethodAndArg() {
              return new PromiseImpl(function(resolve, reject) {
                invoke(method, arg, resolve, reject);
              });
            }
            return previousPromise = // If enqueue has been called before, then we want to wait until
            // all previous Promises have been resolved before calling invoke,
            // so that results are always delivered in the correct order. If
            // enqueue has not been called before, then it is important to
            // call invoke immediately, without waiting on a callback to fire,
            // so that the async generator function has the opportunity to do
            // any necessary setup in a predictable way. This predictability
            // is why the Promise constructor synchronously invokes its
            // executor callback, and why async functions synchronously
            // execute code before the first await. Since we implement simple
            // async functions in terms of async generators, it is especially
            // important to get this right, even though it requires care.
            previousPromise ? previousPromise.then(
              callInvokeWithMethodAndArg,
              // Avoid propagating failures to Promises returned by later
              // invocations of the iterator.
              callInvokeWithMethodAndArg
            ) : callInvokeWithMethodAndArg();
          }
          defineProperty(this, "_invoke", { value: enqueue });
        }
        defineIteratorMethods(AsyncIterator.prototype);
        define(AsyncIterator.prototype, asyncIteratorSymbol, function() {
          return this;
        });
        exports2.AsyncIterator = AsyncIterator;
        exports2.async = function(innerFn, outerFn, self, tryLocsList, PromiseImpl) {
          if (PromiseImpl === void 0) PromiseImpl = Promise;
          var iter = new AsyncIterator(
            wrap(innerFn, outerFn, self, tryLocsList),
            PromiseImpl
          );
          return exports2.isGeneratorFunction(outerFn) ? iter : iter.next().then(function(result) {
            return result.done ? result.value : iter.next();
          });
        };
        function makeInvokeMethod(innerFn, self, context) {
          var state3 = GenStateSuspendedStart;
          return function invoke(method, arg) {
            if (state3 === GenStateExecuting) {
              throw new Error("Generator is already running");
            }
            if (state3 === GenStateCompleted) {
              if (method === "throw") {
                throw arg;
              }
              return doneResult();
            }
            context.method = method;
            context.arg = arg;
            while (true) {
              var delegate = context.delegate;
              if (delegate) {
                var delegateResult = maybeInvokeDelegate(delegate, context);
                if (delegateResult) {
                  if (delegateResult === ContinueSentinel) continue;
                  return delegateResult;
                }
              }
              if (context.method === "next") {
                context.sent = context._sent = context.arg;
              } else if (context.method === "throw") {
                if (state3 === GenStateSuspendedStart) {
                  state3 = GenStateCompleted;
                  throw context.arg;
                }
                context.dispatchException(context.arg);
              } else if (context.method === "return") {
                context.abrupt("return", context.arg);
              }
              state3 = GenStateExecuting;
              var record = tryCatch(innerFn, self, context);
              if (record.type === "normal") {
                state3 = context.done ? GenStateCompleted : GenStateSuspendedYield;
                if (record.arg === ContinueSentinel) {
                  continue;
                }
                return {
                  value: record.arg,
                  done: context.done
                };
              } else if (record.type === "throw") {
                state3 = GenStateCompleted;
                context.method = "throw";
                context.arg = record.arg;
              }
            }
          };
        }
        function maybeInvokeDelegate(delegate, context) {
          var methodName = context.method;
          var method = delegate.iterator[methodName];
          if (method === undefined2) {
            context.delegate = null;
            if (methodName === "throw" && delegate.iterator["return"]) {
              context.method = "return";
              context.arg = undefined2;
              maybeInvokeDelegate(delegate, context);
              if (context.method === "throw") {
                return ContinueSentinel;
              }
            }
            if (methodName !== "return") {
              context.method = "throw";
              context.arg = new TypeError(
                "The iterator does not provide a '" + methodName + "' method"
              );
            }
            return ContinueSentinel;
          }
          var record = tryCatch(method, delegate.iterator, context.arg);
          if (record.type === "throw") {
            context.method = "throw";
            context.arg = record.arg;
            context.delegate = null;
            return ContinueSentinel;
          }
          var info = record.arg;
          if (!info) {
            context.method = "throw";
            context.arg = new TypeError("iterator result is not an object");
            context.delegate = null;
            return ContinueSentinel;
          }
          if (info.done) {
            context[delegate.resultName] = info.value;
            context.next = delegate.nextLoc;
            if (context.method !== "return") {
              context.method = "next";
              context.arg = undefined2;
            }
          } else {
            return info;
          }
          context.delegate = null;
          return ContinueSentinel;
        }
        defineIteratorMethods(Gp);
        define(Gp, toStringTagSymbol, "Generator");
        define(Gp, iteratorSymbol, function() {
          return this;
        });
        define(Gp, "toString", function() {
          return "[object Generator]";
        });
        function pushTryEntry(locs) {
          var entry = { tryLoc: locs[0] };
          if (1 in locs) {
            entry.catchLoc = locs[1];
          }
          if (2 in locs) {
            entry.finallyLoc = locs[2];
            entry.afterLoc = locs[3];
          }
          this.tryEntries.push(entry);
        }
        function resetTryEntry(entry) {
          var record = entry.completion || {};
          record.type = "normal";
          delete record.arg;
          entry.completion = record;
        }
        function Context(tryLocsList) {
          this.tryEntries = [{ tryLoc: "root" }];
          tryLocsList.forEach(pushTryEntry, this);
          this.reset(true);
        }
        exports2.keys = function(val) {
          var object = Object(val);
          var keys = [];
          for (var key in object) {
            keys.push(key);
          }
          keys.reverse();
          return function next2() {
            while (keys.length) {
              var key2 = keys.pop();
              if (key2 in object) {
                next2.value = key2;
                next2.done = false;
                return next2;
              }
            }
            next2.done = true;
            return next2;
          };
        };
        function values(iterable) {
          if (iterable != null) {
            var iteratorMethod = iterable[iteratorSymbol];
            if (iteratorMethod) {
              return iteratorMethod.call(iterable);
            }
            if (typeof iterable.next === "function") {
              return iterable;
            }
            if (!isNaN(iterable.length)) {
              var i = -1, next2 = function next3() {
                while (++i < iterable.length) {
                  if (hasOwn.call(iterable, i)) {
                    next3.value = iterable[i];
                    next3.done = false;
                    return next3;
                  }
                }
                next3.value = undefined2;
                next3.done = true;
                return next3;
              };
              return next2.next = next2;
            }
          }
          throw new TypeError(typeof iterable + " is not iterable");
        }
        exports2.values = values;
        function doneResult() {
          return { value: undefined2, done: true };
        }
        Context.prototype = {
          constructor: Context,
          reset: function(skipTempReset) {
            this.prev = 0;
            this.next = 0;
            this.sent = this._sent = undefined2;
            this.done = false;
            this.delegate = null;
            this.method = "next";
            this.arg = undefined2;
            this.tryEntries.forEach(resetTryEntry);
            if (!skipTempReset) {
              for (var name in this) {
                if (name.charAt(0) === "t" && hasOwn.call(this, name) && !isNaN(+name.slice(1))) {
                  this[name] = undefined2;
                }
              }
            }
          },
          stop: function() {
            this.done = true;
            var rootEntry = this.tryEntries[0];
            var rootRecord = rootEntry.completion;
            if (rootRecord.type === "throw") {
              throw rootRecord.arg;
            }
            return this.rval;
          },
          dispatchException: function(exception) {
            if (this.done) {
              throw exception;
            }
            var context = this;
            function handle2(loc, caught) {
              record.type = "throw";
              record.arg = exception;
              context.next = loc;
              if (caught) {
                context.method = "next";
                context.arg = undefined2;
              }
              return !!caught;
            }
            for (var i = this.tryEntries.length - 1; i >= 0; --i) {
              var entry = this.tryEntries[i];
              var record = entry.completion;
              if (entry.tryLoc === "root") {
                return handle2("end");
              }
              if (entry.tryLoc <= this.prev) {
                var hasCatch = hasOwn.call(entry, "catchLoc");
                var hasFinally = hasOwn.call(entry, "finallyLoc");
                if (hasCatch && hasFinally) {
                  if (this.prev < entry.catchLoc) {
                    return handle2(entry.catchLoc, true);
                  } else if (this.prev < entry.finallyLoc) {
                    return handle2(entry.finallyLoc);
                  }
                } else if (hasCatch) {
                  if (this.prev < entry.catchLoc) {
                    return handle2(entry.catchLoc, true);
                  }
                } else if (hasFinally) {
                  if (this.prev < entry.finallyLoc) {
                    return handle2(entry.finallyLoc);
                  }
                } else {
                  throw new Error("try statement without catch or finally");
                }
              }
            }
          },
          abrupt: function(type, arg) {
            for (var i = this.tryEntries.length - 1; i >= 0; --i) {
              var entry = this.tryEntries[i];
              if (entry.tryLoc <= this.prev && hasOwn.call(entry, "finallyLoc") && this.prev < entry.finallyLoc) {
                var finallyEntry = entry;
                break;
              }
            }
            if (finallyEntry && (type === "break" || type === "continue") && finallyEntry.tryLoc <= arg && arg <= finallyEntry.finallyLoc) {
              finallyEntry = null;
            }
            var record = finallyEntry ? finallyEntry.completion : {};
            record.type = type;
            record.arg = arg;
            if (finallyEntry) {
              this.method = "next";
              this.next = finallyEntry.finallyLoc;
              return ContinueSentinel;
            }
            return this.complete(record);
          },
          complete: function(record, afterLoc) {
            if (record.type === "throw") {
              throw record.arg;
            }
            if (record.type === "break" || record.type === "continue") {
              this.next = record.arg;
            } else if (record.type === "return") {
              this.rval = this.arg = record.arg;
              this.method = "return";
              this.next = "end";
            } else if (record.type === "normal" && afterLoc) {
              this.next = afterLoc;
            }
            return ContinueSentinel;
          },
          finish: function(finallyLoc) {
            for (var i = this.tryEntries.length - 1; i >= 0; --i) {
              var entry = this.tryEntries[i];
              if (entry.finallyLoc === finallyLoc) {
                this.complete(entry.completion, entry.afterLoc);
                resetTryEntry(entry);
                return ContinueSentinel;
              }
            }
          },
          "catch": function(tryLoc) {
            for (var i = this.tryEntries.length - 1; i >= 0; --i) {
              var entry = this.tryEntries[i];
              if (entry.tryLoc === tryLoc) {
                var record = entry.completion;
                if (record.type === "throw") {
                  var thrown = record.arg;
                  resetTryEntry(entry);
                }
                return thrown;
              }
            }
            throw new Error("illegal catch attempt");
          },
          delegateYield: function(iterable, resultName, nextLoc) {
            this.delegate = {
              iterator: values(iterable),
              resultName,
              nextLoc
            };
            if (this.method === "next") {
              this.arg = undefined2;
            }
            return ContinueSentinel;
          }
        };
        return exports2;
      })(
        // If this script is executing as a CommonJS module, use module.exports
        // as the regeneratorRuntime namespace. Otherwise create a new empty
        // object. Either way, the resulting object will be used to initialize
        // the regeneratorRuntime variable at the top of this file.
        typeof module === "object" ? module.exports : {}
      );
      try {
        regeneratorRuntime = runtime;
      } catch (accidentalStrictMode) {
        if (typeof globalThis === "object") {
          globalThis.regeneratorRuntime = runtime;
        } else {
          Function("r", "regeneratorRuntime = r")(runtime);
        }
      }
    }
  });

  // main.mjs
  var import_runtime = __toESM(require_runtime(), 1);

  // shared/ids.mjs
  var LOADING = "loading";
  var FIRST_LAYOUT = "first-layout";
  var FIRST_PICTURE = "first-picture";
  var FIRST_DEPENDENCIES = "first-dependencies";
  var SHELL = "shell";
  var PAGE = "page";
  var NAV = "nav-";
  var DATASET_PICKER = "dataset-picker";
  var NOTICES = "notices";
  var SHARE = "share";
  var SCHEME_TOGGLE = "scheme-toggle";
  var URL2 = "url";
  var DATASET = (
    /** @type {StoreId<string>} */
    "dataset"
  );
  var SELECTION = (
    /** @type {StoreId<Selection>} */
    "selection"
  );
  var VIEW = (
    /** @type {StoreId<Record<string, string>>} */
    "view"
  );
  var VIEW_CHANGE = (
    /** @type {StoreId<Record<string, string | number | boolean | null>>} */
    "view-change"
  );
  var DATASET_CHOICE = (
    /** @type {StoreId<DatasetChoice>} */
    "dataset-choice"
  );
  var STAGE_REQUEST = (
    /** @type {StoreId<StageRequest>} */
    "stage-request"
  );
  var THEME = (
    /** @type {StoreId<"light" | "dark">} */
    "theme"
  );

  // shared/dash.mjs
  var clientside = globalThis.dash_clientside ||= /** @type {any} */
  {};
  function register(namespace, functions) {
    clientside[namespace] = functions;
  }
  var setStore = (store, data2) => clientside.set_props(store, { data: data2 });
  function changeView(values) {
    const view4 = globalThis.dash_component_api.getLayout(VIEW).props.data || {};
    const next2 = { ...view4 };
    for (const [key, value] of Object.entries(values)) {
      if (value === null || value === void 0 || value === "") delete next2[key];
      else next2[key] = String(value);
    }
    if (JSON.stringify(next2) !== JSON.stringify(view4)) setStore(VIEW, next2);
  }
  function notify(title, message2, color = "orange") {
    clientside.set_props(NOTICES, { sendNotifications: [{ action: "show", title, message: message2, color }] });
  }
  function openPage(pathname, stores = {}) {
    history.pushState({}, "", pathname);
    for (const [store, data2] of Object.entries(stores)) setStore(store, data2);
    window.dispatchEvent(new CustomEvent("_dashprivate_pushstate"));
  }

  // shell/refusals.mjs
  var QUIET = 1e4;
  var said = /* @__PURE__ */ new Map();
  function words(status2, body2) {
    if (typeof body2.error !== "string") return null;
    const title = typeof body2.title === "string" ? body2.title : "You may not do this";
    if (status2 === 401) return [title, `${body2.error} Reload the page to sign in; what you see stays until then.`];
    return status2 === 403 ? [title, body2.error] : null;
  }
  async function tell(answer2) {
    const body2 = await answer2.json().catch(() => ({}));
    const now6 = Date.now();
    if (now6 - (said.get(answer2.status) ?? -QUIET) < QUIET) return;
    const text = words(answer2.status, body2 ?? {});
    if (!text) return;
    said.set(answer2.status, now6);
    notify(text[0], text[1], "red");
  }
  function listen() {
    const send4 = window.fetch;
    window.fetch = async (address3, options) => {
      const answer2 = await send4.call(window, address3, options);
      if ((answer2.status === 401 || answer2.status === 403) && new URL(answer2.url, location.href).origin === location.origin) void tell(answer2.clone());
      return answer2;
    };
  }
  if (typeof window !== "undefined") listen();

  // shared/dom.mjs
  var find = (id) => (
    /** @type {Found | null} */
    document.getElementById(id)
  );
  function need(id) {
    const node = find(id);
    if (!node) throw new Error(`The page has no element "${id}".`);
    return node;
  }
  function within(root, selector) {
    const node = root.querySelector(selector);
    if (!node) throw new Error(`Nothing matches "${selector}".`);
    return (
      /** @type {Found} */
      node
    );
  }
  var allWithin = (root, selector) => Array.from(root.querySelectorAll(selector));
  function around(node, selector) {
    const found = node.closest(selector);
    if (!found) throw new Error(`Nothing around it matches "${selector}".`);
    return (
      /** @type {Found} */
      found
    );
  }
  var childrenOf = (node) => (
    /** @type {Found[]} */
    Array.from(node.children)
  );
  var targetOf = (event) => (
    /** @type {Found} */
    event.target
  );
  var hasClass = (event, name) => event.target?.classList?.contains(name) ?? false;
  var closest = (event, selector) => event.target?.closest?.(selector) ?? null;
  function element(name, className = "", ...children) {
    const node = document.createElement(name);
    if (className) node.className = className;
    for (const child of children) if (child !== null && child !== void 0 && child !== "") node.append(
      /** @type {Node} */
      child
    );
    return node;
  }
  function withAttributes(node, attributes) {
    for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, String(value));
    return node;
  }
  function svgElement(name, attributes = {}, ...children) {
    const node = withAttributes(document.createElementNS("http://www.w3.org/2000/svg", name), attributes);
    node.append(...children);
    return node;
  }
  function icon(symbol, size = 14) {
    const node = element("span", `icon icon-${symbol}`);
    node.style.width = node.style.height = `${size}px`;
    node.setAttribute("aria-hidden", "true");
    return node;
  }
  function context2d(canvas, settings) {
    const context = canvas.getContext("2d", settings);
    if (!context) throw new Error("This browser cannot draw on a canvas.");
    return context;
  }
  function setLink(id, address3) {
    const link2 = need(id);
    if (address3) link2.setAttribute("href", address3);
    else link2.removeAttribute("href");
    link2.classList.toggle("disabled", !address3);
    link2.setAttribute("aria-disabled", String(!address3));
  }
  function whenParsed(start3) {
    if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", start3);
    else start3();
  }

  // shell/loading.mjs
  var { suites = {}, plotly = "", pages = {} } = JSON.parse(find(LOADING)?.textContent || "{}");
  var scriptsOf = (pathname) => pages[pathname.split("/").pop() || "library"] || [];
  function whenIdle(act2) {
    if (window.requestIdleCallback) window.requestIdleCallback(act2, { timeout: 2e3 });
    else setTimeout(act2, 500);
  }
  function answerFirstRequests() {
    const answers = /* @__PURE__ */ new Map([
      ["_dash-layout", find(FIRST_LAYOUT)?.textContent],
      ["_dash-dependencies", find(FIRST_DEPENDENCIES)?.textContent]
    ]);
    const send4 = window.fetch;
    window.fetch = (address3, options) => {
      const name = String(address3).split("/").pop() ?? "";
      const text = answers.get(name);
      if (!text) return send4.call(window, address3, options);
      answers.delete(name);
      if (!answers.size) window.fetch = send4;
      return Promise.resolve(new Response(text, { headers: { "Content-Type": "application/json" } }));
    };
  }
  function loadScript(source) {
    return new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = source;
      script.onload = resolve;
      script.onerror = () => reject(new Error(`${source} could not be loaded`));
      document.head.append(script);
    });
  }
  function standIn(namespace, { source, components }) {
    let library2 = null;
    let arrive;
    const arrived = new Promise((resolve) => {
      arrive = resolve;
    });
    let loading = null;
    const load = () => (loading ||= loadScript(source)).then(() => arrived);
    const suite = { getApiAsync: (...parts2) => arrived.then(() => library2?.getApiAsync(...parts2)) };
    Object.defineProperty(window, namespace, {
      get: () => suite,
      set: (value) => {
        if (value === suite) return;
        library2 = value;
        delete library2?.Cytoscape?.defaultProps?.wheelSensitivity;
        arrive();
      }
    });
    for (const name of components) suite[name] = component(name);
    function component(name) {
      const { createElement, lazy, Suspense, useLayoutEffect, useRef, useState } = window.React;
      const Loaded = lazy(() => load().then(() => ({ default: library2?.[name] })));
      const Component = (props) => {
        const place5 = useRef(null);
        const [wanted2, setWanted] = useState(false);
        useLayoutEffect(() => {
          if (place5.current?.offsetParent) setWanted(true);
          else whenIdle(() => setWanted(true));
        }, []);
        if (!wanted2) return createElement("div", { ref: place5 });
        return createElement(Suspense, { fallback: null }, createElement(Loaded, props));
      };
      const ready2 = () => library2?.[name]._dashprivate_isLazyComponentReady ?? true;
      Object.defineProperty(Component, "_dashprivate_isLazyComponentReady", {
        get: () => library2 ? ready2() : arrived.then(ready2)
      });
      return Component;
    }
  }
  function plotlyLater() {
    let library2 = null;
    let loading = null;
    const turn5 = () => new Promise((resolve) => {
      if (scriptsOf(location.pathname).includes(plotly)) resolve();
      else whenIdle(resolve);
    });
    Object.defineProperty(window, "Plotly", {
      get: () => library2 || (loading ||= turn5().then(() => loadScript(plotly)).then(() => library2)),
      set: (value) => {
        library2 = value;
      }
    });
  }
  function fetchAhead(event) {
    const link2 = (
      /** @type {HTMLAnchorElement | null} */
      /** @type {Element | null} */
      closest(event, "a.nav-link")
    );
    for (const address3 of link2 ? scriptsOf(link2.pathname) : []) {
      if (document.head.querySelector(`link[href="${address3}"]`)) continue;
      document.head.append(Object.assign(document.createElement("link"), { rel: "preload", as: "script", href: address3 }));
    }
  }
  answerFirstRequests();
  for (const [namespace, suite] of Object.entries(suites)) standIn(namespace, suite);
  if (plotly) plotlyLater();
  for (const kind of ["pointerover", "focusin"]) document.addEventListener(kind, fetchAhead, { passive: true });

  // shell/first_picture.mjs
  var PATIENCE = 15e3;
  var DRAWN = ".ag-row, .ag-overlay-wrapper, .main-svg";
  function drawn(id) {
    const place5 = find(id);
    return place5 !== null && (place5.dataset.drawn !== void 0 || place5.querySelector(DRAWN) !== null);
  }
  function watch(picture2) {
    const awaited2 = (picture2.dataset.until || "").split(" ").filter(Boolean);
    let wanted2 = true;
    const look2 = () => {
      const stands = find(PAGE)?.firstElementChild;
      if (stands && !picture2.classList.contains("passed")) {
        picture2.classList.add("passed");
        for (const kind of ["pointerdown", "keydown"]) document.addEventListener(kind, () => {
          wanted2 = false;
        }, { once: true });
      }
      if (wanted2 && performance.now() < PATIENCE && !(stands && awaited2.every(drawn))) return requestAnimationFrame(look2);
      requestAnimationFrame(() => picture2.remove());
    };
    look2();
  }
  var picture = find(FIRST_PICTURE);
  if (picture) watch(picture);

  // shared/grid.mjs
  var gridFunctions = window.dashAgGridFunctions ||= {};
  var cellRenderers = window.dashAgGridComponentFunctions ||= {};
  var reactElement = (...parts2) => window.React.createElement(...parts2);
  async function gridApi(id) {
    const api = await window.dash_ag_grid.getApiAsync(id).catch(() => null);
    return api && !api.isDestroyed() ? api : null;
  }

  // shared/save.mjs
  function save(content, name, type = "text/csv") {
    const blob = content instanceof Blob ? content : new Blob([content], { type });
    const link2 = document.createElement("a");
    link2.href = URL.createObjectURL(blob);
    link2.download = name;
    link2.click();
    setTimeout(() => URL.revokeObjectURL(link2.href), 1e4);
  }
  async function pngOf(svg, scale3 = 2, highest = 16e3) {
    const image = new Image();
    image.src = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
    await image.decode();
    const by = Math.min(scale3, highest / image.height);
    const canvas = document.createElement("canvas");
    canvas.width = Math.round(image.width * by);
    canvas.height = Math.round(image.height * by);
    context2d(canvas).drawImage(image, 0, 0, canvas.width, canvas.height);
    URL.revokeObjectURL(image.src);
    return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
  }

  // shared/downloads.mjs
  var drawings = {};
  var dataset = () => {
    const picker = find(DATASET_PICKER);
    return picker && picker.value || "motionscape";
  };
  var cell = (value) => {
    const text = value === null || value === void 0 ? "" : String(value);
    return /[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
  };
  var plain = (values) => values && values._inputArray || values || [];
  function table(plot) {
    const layout = plot._fullLayout;
    const title = (axis, other) => layout[axis] && layout[axis].title && layout[axis].title.text || other;
    const rows2 = [["series", title("xaxis", "x"), title("yaxis", "y"), "value"]];
    for (const trace of plot._fullData) {
      if (trace.visible === false || trace.hoverinfo === "skip") continue;
      const x = plain(trace.x), y = plain(trace.y), z = trace.z;
      const name = trace.name || "";
      if (z) for (let j = 0; j < z.length; j++) for (let i = 0; i < z[j].length; i++) rows2.push([name, x[i] ?? i, y[j] ?? j, z[j][i]]);
      else for (let i = 0; i < Math.max(x.length, y.length); i++) rows2.push([name, x[i] ?? i, y[i], ""]);
    }
    if (rows2.every((row7, i) => i === 0 || row7[3] === "")) for (const row7 of rows2) row7.pop();
    return rows2.map((row7) => row7.map(cell).join(",")).join("\n") + "\n";
  }
  function chart(target2, kind, name) {
    const box4 = find(target2);
    const plot = box4 && (box4.classList.contains("js-plotly-plot") ? box4 : box4.querySelector(".js-plotly-plot"));
    if (!plot) return;
    if (kind === "csv") save(table(plot), name + ".csv");
    else window.Plotly.downloadImage(plot, { format: kind, filename: name, scale: kind === "png" ? 2 : 1 });
  }
  async function drawing(target2, kind, name) {
    const address3 = drawings[target2]();
    if (address3) await savePicture(address3, kind, name);
  }
  async function savePicture(address3, kind, name) {
    const answer2 = await fetch(address3).catch(() => null);
    if (!answer2 || !answer2.ok) {
      notify("The picture was not saved", "The server did not make it; reload the page and try again.");
      return;
    }
    const text = await answer2.text();
    if (kind === "svg") return save(text, name + ".svg", "image/svg+xml");
    const png = await pngOf(text);
    if (png) save(png, name + ".png", "image/png");
  }
  register("downloads", {
    /** @param {{ address?: string } | null} ready */
    fetch(ready2) {
      if (ready2 && ready2.address) {
        const link2 = document.createElement("a");
        link2.href = ready2.address;
        link2.download = "";
        link2.click();
      }
      return clientside.no_update;
    }
  });
  document.addEventListener("click", async (event) => {
    const button5 = closest(event, "[data-save]");
    if (!button5) return;
    const { save: what, target: target2 = "", kind = "" } = button5.dataset;
    const name = `${dataset()} ${button5.dataset.name}`;
    if (what === "chart") chart(target2, kind, name);
    else if (what === "drawing") drawing(target2, kind, name);
    else {
      const api = await gridApi(target2);
      const columns = api && api.getColumns().map((column) => column.getColId()).filter((id) => !["strip", "key"].includes(id));
      if (api) api.exportDataAsCsv({ fileName: name + ".csv", columnKeys: columns });
    }
  });

  // stage/ids.mjs
  var STAGE = "stage";
  var STAGE_CANVAS = "stage-canvas";

  // shared/numbers.mjs
  var clamp = (value, low, high) => Math.min(Math.max(value, low), high);
  function nearest(list3, value) {
    let low = 0;
    let high = list3.length - 1;
    while (high - low > 1) {
      const middle = low + high >> 1;
      if (list3[middle] <= value) low = middle;
      else high = middle;
    }
    return high < 0 ? -1 : Math.abs(list3[low] - value) <= Math.abs(list3[high] - value) ? low : high;
  }

  // stage/camera.mjs
  var FIELD_OF_VIEW = 30 * Math.PI / 180;
  var NEAR = 0.1;
  var [NEAREST, FURTHEST] = [2.2, 200];
  var Camera = class {
    constructor() {
      this.follow = true;
      this.centre = [0, 0];
      this.eye = new Float64Array(3);
      this.target = [0, 0, 0];
      this.right = [1, 0, 0];
      this.up = [0, 1, 0];
      this.forward = [0, 0, -1];
      this.focal = this.middleX = this.middleY = 1;
      this.moved = false;
      this.yaw = this.pitch = 0;
      this.pan = [0, 0, 0];
      this.distance = 5;
      this.reset({ yaw: 0.62, pitch: 0.2 });
    }
    /** @param {{ yaw: number, pitch: number }} view */
    reset({ yaw, pitch }) {
      this.moved = false;
      this.yaw = yaw;
      this.pitch = pitch;
      this.pan = [0, 0.85, 0];
      this.distance = 5;
    }
    /** @param {number} dx @param {number} dy */
    orbit(dx, dy) {
      this.yaw -= dx;
      this.pitch = clamp(this.pitch + dy, 0.01, 1.55);
    }
    /** @param {number} factor */
    zoom(factor) {
      this.moved = true;
      this.distance = clamp(this.distance * factor, 0.6, 200);
    }
    /**
     * Shift by pixels of a view that is `height` pixels high, in the plane that faces the camera.
     * @param {number} dx
     * @param {number} dy
     * @param {number} height
     */
    shift(dx, dy, height) {
      const metres = 2 * this.distance * Math.tan(FIELD_OF_VIEW / 2) / height;
      for (let k = 0; k < 3; k++) this.pan[k] += metres * (dy * this.up[k] - dx * this.right[k]);
      this.pan[1] = clamp(this.pan[1], -1, 20);
      this.moved = true;
    }
    /**
     * Glide towards the followed point, or be there at once.
     * @param {number} x
     * @param {number} z
     * @param {number} seconds
     * @param {boolean} immediately
     */
    track(x, z, seconds, immediately) {
      const share2 = immediately ? 1 : 1 - Math.exp(-seconds * 6);
      this.centre[0] += (x - this.centre[0]) * share2;
      this.centre[1] += (z - this.centre[1]) * share2;
    }
    /**
     * Stand as near as shows a cloud of points around the target, with room at the edges.
     * @param {ArrayLike<number>} cloud
     * @param {number} aspect
     */
    fit(cloud, aspect) {
      if (this.moved) return;
      const vertical = Math.tan(FIELD_OF_VIEW / 2);
      this.prepare(1, 1);
      const tooNear = ({ low, high, wide }) => high - low > 1.5 * vertical || wide > 0.86 * vertical * aspect;
      let [near, far] = [NEAREST, FURTHEST];
      if (!tooNear(this.span(cloud, near))) far = near;
      while (far / near > 1.02) {
        const middle = Math.sqrt(near * far);
        if (tooNear(this.span(cloud, middle))) near = middle;
        else far = middle;
      }
      const span = this.span(cloud, far);
      this.distance = far;
      this.pan = [0, far * (span.high + span.low) / 2 / this.up[1], 0];
    }
    /**
     * Tangents of the angles at which a cloud around the origin is seen from this far: lowest, highest, widest.
     * @param {ArrayLike<number>} cloud
     * @param {number} distance
     */
    span(cloud, distance) {
      const { right: r, up: u, forward: f } = this;
      let [low, high, wide] = [Infinity, 0, 0];
      for (let k = 0; k < cloud.length; k += 3) {
        const depth2 = Math.max(distance + cloud[k] * f[0] + cloud[k + 1] * f[1] + cloud[k + 2] * f[2], NEAR);
        const side = Math.abs(cloud[k] * r[0] + cloud[k + 2] * r[2]) / depth2;
        const rise = (cloud[k] * u[0] + cloud[k + 1] * u[1] + cloud[k + 2] * u[2]) / depth2;
        if (side > wide) wide = side;
        if (rise > high) high = rise;
        if (rise < low) low = rise;
      }
      return { low, high, wide };
    }
    /**
     * Set up for a view of this size in pixels; call before projecting.
     * @param {number} width
     * @param {number} height
     */
    prepare(width, height) {
      const [sy, cy, sp, cp] = [Math.sin(this.yaw), Math.cos(this.yaw), Math.sin(this.pitch), Math.cos(this.pitch)];
      this.right = [cy, 0, -sy];
      this.up = [-sy * sp, cp, -cy * sp];
      this.forward = [-sy * cp, -sp, -cy * cp];
      this.target = [this.centre[0] + this.pan[0], this.pan[1], this.centre[1] + this.pan[2]];
      for (let k = 0; k < 3; k++) this.eye[k] = this.target[k] - this.distance * this.forward[k];
      this.focal = height / 2 / Math.tan(FIELD_OF_VIEW / 2);
      this.middleX = width / 2;
      this.middleY = height / 2;
    }
    /**
     * Distance along the view of a point; projectable where it exceeds `NEAR`.
     * @param {number} x
     * @param {number} y
     * @param {number} z
     */
    depth(x, y, z) {
      const { forward: f, eye: e } = this;
      return (x - e[0]) * f[0] + (y - e[1]) * f[1] + (z - e[2]) * f[2];
    }
    /**
     * Points (n, 3) to screen x, y, pixels per metre and depth, written into arrays of length n.
     * @param {ArrayLike<number>} points
     * @param {number} n
     * @param {Float32Array} x
     * @param {Float32Array} y
     * @param {Float32Array} scale
     * @param {Float32Array} depth
     */
    project(points, n, x, y, scale3, depth2) {
      const { right: r, up: u, forward: f, eye: e } = this;
      for (let j = 0, k = 0; j < n; j++, k += 3) {
        const a = points[k] - e[0];
        const b = points[k + 1] - e[1];
        const c = points[k + 2] - e[2];
        const d = a * f[0] + b * f[1] + c * f[2];
        const s = this.focal / Math.max(d, NEAR);
        x[j] = this.middleX + s * (a * r[0] + c * r[2]);
        y[j] = this.middleY - s * (a * u[0] + b * u[1] + c * u[2]);
        scale3[j] = s;
        depth2[j] = d;
      }
    }
  };

  // stage/colours.mjs
  var FOG_LEVELS = 8;
  var VARIABLES = ["sky", "haze", "floor", "rim", "grid", "shadow", "contact", "left", "right", "spine", "text", "muted", "accent"];
  var HUES = [255, 55, 155, 330, 95, 205, 25, 285, 125, 0, 230, 75];
  var LIFTS = [0, 0.02, -0.02, 0.03, 0.05, 0.06, -0.05, -0.03, 0.04, -0.06, 0.08, -0.02];
  var scratch = null;
  function parseColour(colour) {
    scratch ??= document.createElement("canvas").getContext("2d", { willReadFrequently: true });
    if (!scratch) return [128, 128, 128];
    scratch.fillStyle = "#808080";
    scratch.fillStyle = colour;
    scratch.clearRect(0, 0, 1, 1);
    scratch.fillRect(0, 0, 1, 1);
    return Array.from(scratch.getImageData(0, 0, 1, 1).data.slice(0, 3));
  }
  var mix = (a, b, share2) => a.map((value, k) => value + (b[k] - value) * share2);
  var css = (rgb) => `rgb(${rgb.map((v) => Math.round(Math.min(Math.max(v, 0), 255))).join(",")})`;
  function oklch(lightness, chroma, degrees) {
    const [a, b] = [chroma * Math.cos(degrees * Math.PI / 180), chroma * Math.sin(degrees * Math.PI / 180)];
    const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
    const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
    const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
    const linear = [
      4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
      -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
      -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s
    ];
    return linear.map((v) => 255 * (v <= 31308e-7 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
  }
  function readTheme(element2) {
    const style = getComputedStyle(element2);
    const theme = {};
    for (const name of VARIABLES) theme[name] = parseColour(style.getPropertyValue(`--ms-stage-${name}`).trim());
    theme.dark = theme.sky[0] + theme.sky[1] + theme.sky[2] < 384;
    theme.font = style.fontFamily;
    return (
      /** @type {Theme} */
      theme
    );
  }
  function figureColours(theme, k, n, own2) {
    if (own2) {
      const base = parseColour(own2);
      return [mix(base, [255, 255, 255], 0.25), mix(base, [0, 0, 0], 0.25), base];
    }
    if (n === 1) return [theme.left, theme.right, theme.spine];
    const [hue, round2] = [HUES[k % HUES.length], Math.floor(k / HUES.length)];
    const lightness = (theme.dark ? 0.7 : 0.6) + LIFTS[k % LIFTS.length] - 0.09 * (round2 % 3);
    return [0.085, -0.085, 0].map((lift) => oklch(lightness + lift, theme.dark ? 0.125 : 0.135, hue + 15 * round2));
  }
  function shades(theme, colours, fade) {
    const levels = (change2) => colours.map((rgb) => Array.from({ length: FOG_LEVELS }, (_, level) => css(mix(change2(rgb), theme.haze, fade + (1 - fade) * 0.4 * (level / (FOG_LEVELS - 1))))));
    const balls = [];
    return {
      /** @param {number} level */
      ball: (level) => balls[level] ??= ball(theme, colours[2], fade + (1 - fade) * 0.4 * (level / (FOG_LEVELS - 1))),
      fill: levels((rgb) => rgb),
      edge: levels((rgb) => mix(rgb, theme.dark ? [8, 10, 14] : [20, 24, 32], theme.dark ? 0.62 : 0.42)),
      sheen: levels((rgb) => mix(rgb, [255, 255, 255], theme.dark ? 0.1 : 0.13)),
      light: levels((rgb) => mix(rgb, [255, 255, 255], theme.dark ? 0.26 : 0.36))
    };
  }
  function ball(theme, rgb, fog) {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = 96;
    const context = context2d(canvas);
    const gradient = context.createRadialGradient(34, 30, 4, 44, 42, 56);
    const fogged = (colour) => css(mix(colour, theme.haze, fog));
    gradient.addColorStop(0, fogged(mix(rgb, [255, 255, 255], 0.42)));
    gradient.addColorStop(0.5, fogged(rgb));
    gradient.addColorStop(1, fogged(mix(rgb, [0, 0, 0], 0.22)));
    context.fillStyle = gradient;
    context.beginPath();
    context.arc(48, 48, 48, 0, 2 * Math.PI);
    context.fill();
    return canvas;
  }

  // stage/icons.mjs
  var line = (d) => `<path d="${d}" fill="none" stroke="currentColor" stroke-width="1.6" stroke-linecap="round" stroke-linejoin="round"/>`;
  var solid = (d) => `<path d="${d}" fill="currentColor"/>`;
  var dot = (x, y, r, alpha = 1) => `<circle cx="${x}" cy="${y}" r="${r}" fill="currentColor" opacity="${alpha}"/>`;
  var body = (x, alpha = 1) => `<g opacity="${alpha}">${dot(x, 4.6, 1.8)}${line(`M${x} 7.4V12M${x} 12L${x - 2} 16.6M${x} 12L${x + 2} 16.6M${x - 2.6} 9.2H${x + 2.6}`)}</g>`;
  var ICONS = {
    play: solid("M6.5 4.2v11.6c0 .6.7 1 1.2.6l8.4-5.8c.4-.3.4-.9 0-1.2L7.7 3.6c-.5-.4-1.2 0-1.2.6z"),
    pause: solid("M5.6 4h2.6c.4 0 .6.2.6.6v10.8c0 .4-.2.6-.6.6H5.6c-.4 0-.6-.2-.6-.6V4.6c0-.4.2-.6.6-.6zM11.8 4h2.6c.4 0 .6.2.6.6v10.8c0 .4-.2.6-.6.6h-2.6c-.4 0-.6-.2-.6-.6V4.6c0-.4.2-.6.6-.6z"),
    back: line("M6 5v10M14 5.5L8.5 10l5.5 4.5z"),
    forward: line("M14 5v10M6 5.5l5.5 4.5L6 14.5z"),
    slower: line("M5.5 10h9"),
    faster: line("M5.5 10h9M10 5.5v9"),
    loop: line("M4 9.5V9a3 3 0 013-3h8.5M13 3.5L15.5 6 13 8.5M16 10.5v.5a3 3 0 01-3 3H4.5M7 16.5L4.5 14 7 11.5"),
    bounce: line("M3.5 10h13M6.5 7l-3 3 3 3M13.5 7l3 3-3 3"),
    once: line("M3.5 10H14M11 7l3 3-3 3M16.5 5.5v9"),
    ghosts: body(13.5) + body(9.4, 0.55) + body(5.6, 0.28),
    trails: line("M3 15c3.5 0 2.8-7 6.4-7 2.8 0 2.4 4.4 5 4.4") + dot(15.8, 12.2, 1.9),
    follow: dot(10, 10, 2.2) + line("M3.5 7V5A1.5 1.5 0 015 3.5h2M13 3.5h2A1.5 1.5 0 0116.5 5v2M16.5 13v2a1.5 1.5 0 01-1.5 1.5h-2M7 16.5H5A1.5 1.5 0 013.5 15v-2"),
    overlay: body(11.4) + body(8.4, 0.5),
    side: body(5.6) + body(14.4),
    pose: line("M2.5 9h15M2.5 17.5h15") + [3.2, 11.7].map((y) => [5, 10, 15].map((x) => dot(x, y, 1.2) + line(`M${x} ${y + 2.2}v2.2`)).join("")).join(""),
    warp: line("M3.5 5.5h13M3.5 14.5h13M6 5.5L5 14.5M10 5.5l1.5 9M14 5.5l1 9"),
    reset: line("M4 9.2L10 4l6 5.2M5.6 8.2v7.3h3.2v-4h2.4v4h3.2V8.2"),
    help: line("M7.4 7.6a2.6 2.6 0 115 1c-.5 1.2-2.3 1.4-2.3 3.2") + dot(10.1, 15, 1)
  };
  var iconMarkup = (name) => `<svg viewBox="0 0 20 20" width="20" height="20" aria-hidden="true" focusable="false">${ICONS[name] || ""}</svg>`;

  // stage/names.mjs
  var WORTH_LEAVING_OUT = 8;
  function shorten(text, most) {
    const kept = Math.floor((most - 1) / 2);
    return text.length > most ? `${text.slice(0, most - 1 - kept).trimEnd()}…${text.slice(-kept).trimStart()}` : text;
  }
  function sharedBeginning(names2) {
    let n = 0;
    while (n < names2[0].length && names2.every((name) => name[n] === names2[0][n])) n++;
    return names2[0].slice(0, n).replace(/[^\s_\-/.:]*$/, "");
  }
  function nameFigures(figures) {
    if (!figures.length) return;
    const labels2 = figures.map((figure3) => figure3.label);
    const alike = new Set(labels2).size === 1 && labels2.length > 1;
    const shared = alike ? labels2[0] : labels2.length > 1 ? sharedBeginning(labels2) : "";
    const from = alike || shared.length >= WORTH_LEAVING_OUT ? shared.length : 0;
    for (const figure3 of figures) {
      const { label, header, ownFps } = figure3;
      const rest = alike ? "" : label.length > from ? label.slice(from) : label;
      const again = labels2.filter((other) => other === label).length > 1;
      const second = `${(header.start / ownFps).toFixed(1)} s`;
      figure3.name = again ? `${rest} ${second}`.trim() : rest;
      figure3.brief = again ? second : rest.split(/[\s_\-/.:]+/).filter(Boolean).pop() ?? rest;
    }
  }

  // stage/controls.mjs
  var LOOP_WORDS = { loop: "Repeat", bounce: "Back and forth", once: "Play once" };
  var TRAIL_WORDS = { off: "Trails off", root: "Trail of the body", limbs: "Trails of hands and feet" };
  function makeActions(stage2) {
    const { clock: clock2, camera, traces } = stage2;
    const say3 = (text) => stage2.messages.say(text);
    return {
      play: () => clock2.playing ? stage2.pause() : stage2.play(),
      back: () => stage2.step(-1),
      forward: () => stage2.step(1),
      start: () => stage2.seek(0),
      end: () => stage2.seek(clock2.duration),
      slower: () => (clock2.changeSpeed(-1), say3(`Speed ${clock2.speed}×`)),
      faster: () => (clock2.changeSpeed(1), say3(`Speed ${clock2.speed}×`)),
      speed: () => (clock2.speed = 1, say3("Speed 1×")),
      loop: () => (clock2.nextLoop(), say3(LOOP_WORDS[clock2.loop])),
      ghosts: () => (traces.ghosts = !traces.ghosts, say3(traces.ghosts ? "Ghosts on" : "Ghosts off")),
      trails: () => (traces.nextTrails(), say3(TRAIL_WORDS[traces.trails])),
      follow: () => (camera.follow = !camera.follow, say3(camera.follow ? "Camera follows" : "Camera stands still")),
      overlay: () => stage2.setLayout("overlay"),
      side: () => stage2.setLayout("side"),
      pose: () => stage2.setLayout("pose"),
      warp: () => stage2.setSync(stage2.sync === "warp" ? "start" : "warp"),
      reset: () => stage2.resetCamera(),
      help: () => stage2.messages.toggleHelp(),
      retry: () => stage2.requests.show(stage2.request ?? null)
    };
  }
  var KEYS = {
    " ": "play",
    k: "play",
    Home: "start",
    End: "end",
    "+": "faster",
    "=": "faster",
    "-": "slower",
    _: "slower",
    0: "speed",
    l: "loop",
    g: "ghosts",
    t: "trails",
    f: "follow",
    r: "reset",
    1: "overlay",
    2: "side",
    3: "pose",
    s: "warp",
    "?": "help",
    ArrowLeft: "back",
    ArrowRight: "forward"
  };
  var ORBIT = { ArrowLeft: [-0.12, 0], ArrowRight: [0.12, 0], ArrowUp: [0, 0.08], ArrowDown: [0, -0.08] };
  function onKey(stage2, actions4, event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    const button5 = closest(event, "button");
    if (button5 && (event.key === " " || event.key === "Enter")) return;
    if (event.key === "Escape" && stage2.messages.toggleHelp(false)) return;
    const orbit = event.shiftKey && ORBIT[event.key];
    const action = KEYS[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (orbit) stage2.camera.orbit(...orbit);
    else if (event.key === "ArrowUp") stage2.camera.zoom(0.9);
    else if (event.key === "ArrowDown") stage2.camera.zoom(1 / 0.9);
    else if (event.key === "PageUp") stage2.step(-10);
    else if (event.key === "PageDown") stage2.step(10);
    else if (action) actions4[action]();
    else return;
    event.preventDefault();
    stage2.touch(true);
  }
  function watchPointer(stage2, canvas) {
    const pointers = /* @__PURE__ */ new Map();
    const spread = () => {
      const [a, b] = [...pointers.values()];
      return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
    };
    canvas.addEventListener("pointerdown", (event) => {
      pointers.set(event.pointerId, event);
      canvas.setPointerCapture(event.pointerId);
      canvas.classList.add("ms-grabbing");
    });
    canvas.addEventListener("pointermove", (event) => {
      const before2 = pointers.get(event.pointerId);
      if (!before2) return stage2.pointAt(event.offsetX, event.offsetY);
      const pinch = pointers.size === 2 ? spread() : 0;
      const [dx, dy] = [event.clientX - before2.clientX, event.clientY - before2.clientY];
      pointers.set(event.pointerId, event);
      const pan = pinch || event.shiftKey || event.buttons & 6;
      if (pan) stage2.camera.shift(dx / Math.max(pointers.size, 1), dy / Math.max(pointers.size, 1), canvas.clientHeight);
      else stage2.camera.orbit(75e-4 * dx, 75e-4 * dy);
      if (pinch) stage2.camera.zoom(pinch / Math.max(spread(), 1));
      stage2.touch(true);
    });
    const release2 = (event) => {
      pointers.delete(event.pointerId);
      if (!pointers.size) canvas.classList.remove("ms-grabbing");
    };
    canvas.addEventListener("pointerup", release2);
    canvas.addEventListener("pointercancel", release2);
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("dblclick", () => stage2.resetCamera());
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      stage2.camera.zoom(Math.exp(Math.min(Math.max(event.deltaY, -120), 120) * 16e-4));
      stage2.touch(true);
    }, { passive: false });
  }
  function watchSeeking(stage2, bar) {
    let resume = false;
    const seek = (event) => {
      const box4 = bar.getBoundingClientRect();
      stage2.seek(stage2.clock.duration * Math.min(Math.max((event.clientX - box4.left) / box4.width, 0), 1));
    };
    bar.addEventListener("pointerdown", (event) => {
      bar.setPointerCapture(event.pointerId);
      resume = stage2.clock.playing;
      stage2.clock.playing = false;
      seek(event);
    });
    bar.addEventListener("pointermove", (event) => bar.hasPointerCapture(event.pointerId) && seek(event));
    const release2 = () => {
      if (resume) stage2.play();
      resume = false;
      stage2.touch(true);
    };
    bar.addEventListener("pointerup", release2);
    bar.addEventListener("pointercancel", release2);
  }
  var CHIP_LETTERS = 20;
  function legend(side) {
    const entry = document.createElement("span");
    entry.className = `ms-legend ms-legend-${side}`;
    entry.textContent = side;
    return entry;
  }
  var Controls = class {
    /** @param {Stage} stage @param {HTMLElement} root */
    constructor(stage2, root) {
      this.stage = stage2;
      this.root = root;
      this.actions = makeActions(stage2);
      this.listed = "";
      this.shown = "";
      this.scrub = this.find(".ms-scrub");
      for (const button5 of allWithin(root, "[data-icon]")) button5.innerHTML = iconMarkup(button5.dataset.icon ?? "");
      root.addEventListener("click", (event) => this.press(event));
      root.addEventListener("keydown", (event) => onKey(stage2, this.actions, event));
      watchPointer(stage2, stage2.scene.canvas);
      watchSeeking(stage2, this.scrub);
      watchSeeking(stage2, this.find(".ms-bands"));
      watchSeeking(stage2, this.find(".ms-warp-rows"));
      this.find(".ms-warp-rows").addEventListener("pointermove", (event) => {
        this.find(".ms-warp-rows").title = stage2.warpStrip.describe(event);
      });
    }
    /** The part of the controls that matches. @param {string} selector */
    find(selector) {
      return within(this.root, selector);
    }
    /** @param {Event} event */
    press(event) {
      const button5 = closest(event, "[data-action]");
      if (!button5 || button5.disabled) return;
      this.actions[button5.dataset.action ?? ""]?.();
      this.stage.touch(true);
    }
    /** Chips that name the figures and hide or show them; pointing at one makes it stand out. */
    listFigures() {
      const { figures } = this.stage;
      const list3 = this.find(".ms-figures");
      const names2 = JSON.stringify(figures.map((figure3) => [figure3.label, figure3.visible, figure3.item.colour, figure3.header.start]));
      if (names2 === this.listed) return;
      this.listed = names2;
      list3.replaceChildren(...figures.length > 1 ? figures.map((figure3, k) => this.chip(figure3, k)) : []);
      if (figures.length === 1 && !figures[0].item.colour) list3.append(legend("left"), legend("right"));
    }
    /** @param {Figure} figure @param {number} k */
    chip(figure3, k) {
      const chip2 = document.createElement("button");
      chip2.type = "button";
      chip2.className = "ms-chip";
      chip2.title = `${figure3.label}, frames ${figure3.header.start} to ${figure3.header.end}: click to hide or show`;
      chip2.setAttribute("aria-pressed", String(figure3.visible));
      const colour = document.createElement("span");
      colour.className = "ms-chip-colour";
      const name = document.createElement("span");
      name.className = "ms-chip-name";
      name.textContent = shorten(figure3.name, CHIP_LETTERS);
      chip2.append(colour, name);
      chip2.addEventListener("click", () => {
        const { visible: visible2 } = this.stage.figures[k];
        this.stage.setVisible(k, !visible2);
        chip2.setAttribute("aria-pressed", String(!visible2));
      });
      chip2.addEventListener("pointerenter", () => this.stage.highlight(k));
      chip2.addEventListener("pointerleave", () => this.stage.highlight(-1));
      return chip2;
    }
    colourChips() {
      allWithin(this.root, ".ms-chip-colour").forEach((swatch, k) => {
        const figure3 = this.stage.figures[k];
        if (figure3) swatch.style.background = css(figure3.colours[2]);
      });
    }
    /** Bring all buttons in line with the state; cheap enough after every action, not for every frame. */
    update() {
      const { stage: stage2 } = this;
      const { clock: clock2, traces, camera } = stage2;
      const show6 = (action, icon2, label, pressed) => {
        const button5 = this.find(`.ms-tool[data-action="${action}"]`);
        if (icon2 && button5.dataset.icon !== icon2) button5.innerHTML = iconMarkup(button5.dataset.icon = icon2);
        if (label) {
          button5.setAttribute("aria-label", label);
          button5.dataset.tip = `${label}${button5.dataset.key ? `  ·  ${button5.dataset.key}` : ""}`;
        }
        if (pressed !== void 0) button5.setAttribute("aria-pressed", String(pressed));
      };
      show6("play", clock2.playing ? "pause" : "play", clock2.playing ? "Pause" : "Play");
      show6("loop", clock2.loop, LOOP_WORDS[clock2.loop]);
      show6("ghosts", null, null, traces.ghosts);
      show6("trails", null, TRAIL_WORDS[traces.trails], traces.trails !== "off");
      show6("follow", null, null, camera.follow);
      show6("overlay", null, null, stage2.layout === "overlay");
      show6("side", null, null, stage2.layout === "side");
      show6("pose", null, null, stage2.layout === "pose");
      show6("warp", null, null, stage2.timeline.warped);
      this.find('[data-action="speed"]').textContent = `${clock2.speed}×`;
      const many = stage2.figures.length > 1;
      this.find(".ms-arrangement").hidden = !many;
      this.find('.ms-tool[data-action="warp"]').disabled = !stage2.figures.some((figure3) => figure3.warp);
      this.find(".ms-controls").inert = stage2.status !== "ready";
    }
    /**
     * For every frame: the scrub bar and the clock face.
     * @param {string} text
     */
    tick(text) {
      const { clock: clock2 } = this.stage;
      const share2 = clock2.duration > 0 ? clock2.time / clock2.duration : 0;
      this.scrub.style.setProperty("--share", share2.toFixed(4));
      this.stage.warpStrip.place(share2);
      this.stage.bands.place(share2);
      if (text === this.shown) return;
      this.shown = text;
      this.find(".ms-readout").textContent = text;
      if (clock2.playing) return;
      this.scrub.setAttribute("aria-valuemax", clock2.duration.toFixed(2));
      this.scrub.setAttribute("aria-valuenow", clock2.time.toFixed(2));
      this.scrub.setAttribute("aria-valuetext", text);
    }
  };

  // stage/events.mjs
  var STATE_EVERY = 400;
  var StageEvents = class {
    /** @param {Stage} stage */
    constructor(stage2) {
      this.stage = stage2;
      this.waiting = 0;
      this.lastFrame = void 0;
    }
    /** "stage-state", a little later, so that many changes make one event: for the link. */
    tellState() {
      const { stage: stage2 } = this;
      if (this.waiting || stage2.status !== "ready") return;
      this.waiting = window.setTimeout(() => {
        this.waiting = 0;
        window.dispatchEvent(new CustomEvent("stage-state", { detail: { ...stage2.state(), items: stage2.standing() } }));
      }, STATE_EVERY);
    }
    /** "stage-frame", where another frame is shown than before: for cursors in charts and lit nodes. */
    tellFrame() {
      const { stage: stage2 } = this;
      const { time, duration, playing: playing3 } = stage2.clock;
      if (stage2.status !== "ready" || time === this.lastFrame?.time && stage2.figures === this.lastFrame.figures) return;
      this.lastFrame = { time, figures: stage2.figures };
      window.dispatchEvent(new CustomEvent("stage-frame", { detail: { time, duration, playing: playing3, items: stage2.standing() } }));
      if (playing3) this.tellState();
    }
  };

  // stage/layout.mjs
  var LANE = { least: 1, most: 2.4, gap: 0.3 };
  var ROW = { least: 1.5, most: 3.2 };
  var SHELF = { least: 0.75, most: 2.2, gap: 0.22, above: 0.5 };
  var TURN = 0.5;
  function placeFigures(figures, layout, aspect, duration) {
    const still = layout === "pose";
    for (const figure3 of figures) {
      figure3.place = [0, 0];
      figure3.level = 0;
      figure3.room = Infinity;
      figure3.walksInPlace = still;
      figure3.path = null;
      figure3.stand(still ? figure3.frameAt(duration / 2) : 0);
    }
    const shown9 = figures.filter((figure3) => figure3.visible);
    if (layout === "overlay" || shown9.length < 2) return [];
    for (const figure3 of shown9) figure3.turn(TURN);
    if (still) return placeOnShelves(shown9, aspect, duration);
    placeInLanes(shown9, aspect);
    return [];
  }
  function placeInLanes(shown9, aspect) {
    const boxes = shown9.map((figure3) => figure3.extent());
    const span = (low, high) => Math.max(...boxes.map((b) => b[high] - b[low]));
    const width = Math.min(Math.max(span(0, 1) + LANE.gap, LANE.least), LANE.most);
    const depth2 = Math.min(Math.max(span(2, 3) + LANE.gap, ROW.least), ROW.most);
    const wanted2 = Math.round(Math.sqrt(shown9.length * aspect * (0.6 * depth2 + 0.8) / width));
    inRows(shown9, Math.max(wanted2, 2), (figure3, k, row7, rows2, column) => {
      const box4 = boxes[k];
      figure3.room = width;
      figure3.walksInPlace = box4[1] - box4[0] > LANE.most || box4[3] - box4[2] > ROW.most;
      const middle = figure3.walksInPlace ? [0, 0] : [(box4[0] + box4[1]) / 2, (box4[2] + box4[3]) / 2];
      const stagger = rows2 > 1 ? (row7 % 2 ? 0.25 : -0.25) * width : 0;
      figure3.place = [column * width + stagger - middle[0], ((rows2 - 1) / 2 - row7) * depth2 - middle[1]];
    });
  }
  function placeOnShelves(shown9, aspect, duration) {
    const boxes = shown9.map((figure3) => figure3.extent(duration / 2, duration / 2, 1));
    const width = Math.min(Math.max(...boxes.map((b) => b[1] - b[0] + SHELF.gap), SHELF.least), SHELF.most);
    const height = Math.max(...boxes.map((b) => b[4])) + SHELF.above;
    const size = (columns2) => Math.min(aspect / (columns2 * width), 1 / (Math.ceil(shown9.length / columns2) * height));
    const columns = shown9.map((_, k) => k + 1).reduce((best, k) => size(k) > size(best) ? k : best);
    const shelves = [];
    inRows(shown9, columns, (figure3, k, row7, rows2, column) => {
      figure3.room = width;
      figure3.level = (rows2 - 1 - row7) * height;
      figure3.place = [column * width - (boxes[k][0] + boxes[k][1]) / 2, 0];
      const half = Math.abs(column * width) + width / 2;
      shelves[row7] = { level: figure3.level, half: Math.max(shelves[row7]?.half ?? 0, half) };
    });
    return shelves;
  }
  function inRows(shown9, wanted2, put5) {
    const rows2 = Math.ceil(shown9.length / wanted2);
    const columns = Math.ceil(shown9.length / rows2);
    shown9.forEach((figure3, k) => {
      const row7 = Math.floor(k / columns);
      const inRow = row7 < rows2 - 1 ? columns : shown9.length - columns * (rows2 - 1);
      put5(figure3, k, row7, rows2, k % columns - (inRow - 1) / 2);
    });
  }
  function groundCentre(figures, out) {
    let [x, z, n] = [0, 0, 0];
    for (const figure3 of figures) {
      if (!figure3.visible) continue;
      const root = 3 * figure3.header.root;
      x += figure3.points[root];
      z += figure3.points[root + 2];
      n++;
    }
    out[0] = n ? x / n : 0;
    out[1] = n ? z / n : 0;
    return out;
  }
  function measureStage(figures, duration, samples = 24) {
    const shown9 = figures.filter((figure3) => figure3.visible);
    const cloud = new Float32Array(samples * shown9.reduce((sum2, figure3) => sum2 + figure3.points.length, 0));
    const centre = [0, 0];
    let radius = 0.7;
    let n = 0;
    for (let s = 0; s < samples; s++) {
      for (const figure3 of shown9) figure3.pose(duration * s / (samples - 1));
      groundCentre(shown9, centre);
      for (const { points } of shown9) {
        for (let k = 0; k < points.length; k += 3) {
          cloud[n++] = points[k] - centre[0];
          cloud[n++] = points[k + 1];
          cloud[n++] = points[k + 2] - centre[1];
          radius = Math.max(radius, Math.hypot(cloud[n - 3], cloud[n - 1]));
        }
      }
    }
    return { cloud, radius };
  }
  function homeView(figures, layout) {
    if (layout === "overlay" || figures.length < 2) return { yaw: 0.62, pitch: 0.2 };
    return layout === "pose" ? { yaw: 0.02, pitch: 0.07 } : { yaw: 0.06, pitch: 0.34 };
  }

  // stage/messages.mjs
  var NOTICE = 1100;
  function readout({ clock: { time, duration }, figures, timeline, layout }) {
    const figure3 = figures[timeline.reference];
    const frame = figure3.recordedFrame(time);
    const span = figure3.spanAt(frame)?.label;
    const moment = layout === "pose" ? `${Math.round(100 * time / (duration || 1))} % of each` : `${time.toFixed(2)} / ${duration.toFixed(2)} s`;
    return `${moment} · frame ${frame}${span ? ` · ${span}` : ""}`;
  }
  function describe(figures) {
    const count = figures.length === 1 ? "One figure" : `${figures.length} figures`;
    return `${count} moving: ${figures.slice(0, 6).map((figure3) => figure3.label).join(", ")}`;
  }
  var Messages = class {
    /** @param {HTMLElement} root */
    constructor(root) {
      this.root = root;
      this.timer = 0;
    }
    /** @param {string} title @param {string} message */
    show(title, message2) {
      within(this.root, ".ms-stage-title").textContent = title;
      within(this.root, ".ms-message-text").textContent = message2;
      within(this.root, ".ms-stage-note").hidden = true;
    }
    /** Show for a moment what a button or a key did. @param {string} text */
    say(text) {
      const toast = within(this.root, ".ms-toast");
      toast.textContent = text;
      toast.classList.add("ms-shown");
      clearTimeout(this.timer);
      this.timer = window.setTimeout(() => toast.classList.remove("ms-shown"), NOTICE);
    }
    /** Open or close the list of keys; true when it was open. @param {boolean} [open] */
    toggleHelp(open6) {
      const help = within(this.root, ".ms-help");
      const was = !help.hidden;
      help.hidden = open6 === void 0 ? was : !open6;
      return was;
    }
  };

  // stage/frames.mjs
  var LONGEST_STEP = 0.25;
  var Frames = class {
    /** @param {Stage} stage */
    constructor(stage2) {
      this.stage = stage2;
      this.fps = 0;
      this.stale = true;
      this.before = void 0;
      this.followed = [0, 0];
      this.next = (now6) => this.tick(now6);
    }
    start() {
      requestAnimationFrame(this.next);
    }
    /** @param {number} now */
    tick(now6) {
      const { stage: stage2 } = this;
      if (stage2.closed) return;
      requestAnimationFrame(this.next);
      const seconds = Math.min(Math.max((now6 - (this.before ?? now6)) / 1e3, 0), LONGEST_STEP);
      this.before = now6;
      if (stage2.status !== "ready" && !this.stale) return;
      const playing3 = stage2.clock.playing;
      if (playing3) {
        stage2.clock.advance(seconds);
        this.fps += ((seconds > 0 ? 1 / seconds : 60) - this.fps) * 0.05;
        if (!stage2.clock.playing) stage2.touch(true);
      }
      if (!playing3 && !this.stale) return;
      this.stale = false;
      this.paint(seconds);
    }
    /** @param {number} seconds */
    paint(seconds) {
      const { stage: stage2 } = this;
      const { camera, clock: clock2, figures, scene } = stage2;
      for (const figure3 of figures) if (figure3.visible) figure3.pose(clock2.time);
      if (figures.length) {
        const [x, z] = groundCentre(figures, this.followed);
        if (camera.follow) camera.track(x, z, seconds, clock2.jumped || !clock2.playing);
        clock2.jumped = false;
      }
      scene.paint(camera, figures, stage2.traces, clock2, stage2.layout === "overlay");
      stage2.warpStrip.refresh(scene.theme);
      stage2.controls.tick(figures.length ? readout(stage2) : "");
      stage2.events.tellFrame();
    }
  };

  // stage/looks.mjs
  var Looks = class {
    /** @param {Stage} stage */
    constructor(stage2) {
      this.size = new ResizeObserver(() => stage2.resized());
      this.size.observe(stage2.scene.canvas);
      this.theme = new MutationObserver(() => stage2.readLooks());
      for (const node of [document.documentElement, document.body]) {
        this.theme.observe(node, { attributes: true, attributeFilter: ["data-mantine-color-scheme", "class", "style"] });
      }
    }
    close() {
      this.size.disconnect();
      this.theme.disconnect();
    }
  };

  // stage/spans.mjs
  var PATH_STEPS = 30;
  var MOST_POINTS = 1200;
  var MOST_ROWS = 8;
  function readSpans(colours, { start: start3, end }) {
    if (!Array.isArray(colours)) return [];
    return colours.filter((span) => Number.isFinite(span?.start) && Number.isFinite(span?.end)).map((span) => {
      const rgb = parseColour(String(span.colour ?? ""));
      return { start: Math.max(span.start, start3), end: Math.min(span.end, end), rgb, colour: css(rgb), label: String(span.label ?? "") };
    }).filter((span) => span.end > span.start).sort((a, b) => a.start - b.start);
  }
  var SpanBands = class {
    /** @param {HTMLElement} holder */
    constructor(holder) {
      this.holder = holder;
      this.rows = within(holder, ".ms-band-rows");
      this.cursor = within(holder, ".ms-band-cursor");
    }
    /**
     * A row for each visible figure that has spans, along the Stage's time.
     * @param {Figure[]} figures
     * @param {number} duration
     */
    show(figures, duration) {
      const shown9 = figures.filter((figure3) => figure3.visible && figure3.spans.length).slice(0, MOST_ROWS);
      this.holder.hidden = !shown9.length || !(duration > 0);
      this.rows.classList.toggle("ms-band-thin", shown9.length > 3);
      this.rows.replaceChildren(...this.holder.hidden ? [] : shown9.map((figure3) => row(figure3, duration)));
    }
    /** @param {number} share */
    place(share2) {
      if (!this.holder.hidden) this.cursor.style.left = `${(100 * share2).toFixed(3)}%`;
    }
  };
  function row(figure3, duration) {
    const made = document.createElement("div");
    made.className = "ms-band";
    for (const span of figure3.spans) {
      const block2 = document.createElement("span");
      const [from, to] = [figure3.timeAt(span.start), Math.min(figure3.timeAt(span.end), duration)];
      block2.style.left = `${100 * from / duration}%`;
      block2.style.width = `${100 * Math.max(to - from, 0) / duration}%`;
      block2.style.background = span.colour;
      block2.style.color = 0.3 * span.rgb[0] + 0.59 * span.rgb[1] + 0.11 * span.rgb[2] > 140 ? "#10151d" : "#ffffff";
      block2.textContent = span.label;
      block2.title = `${span.label || "no name"}, frames ${Math.round(span.start)} to ${Math.round(span.end)} of ${figure3.label}`;
      made.append(block2);
    }
    return made;
  }
  function makePath(figure3, duration, plain3) {
    const n = Math.min(Math.max(Math.ceil(duration * PATH_STEPS), 2), MOST_POINTS);
    const points = new Float32Array(3 * n);
    const runs = [];
    const root = 3 * figure3.header.root;
    for (let s = 0; s < n; s++) {
      const time = duration * s / (n - 1);
      figure3.pose(time, figure3.spare);
      points[3 * s] = figure3.spare[root];
      points[3 * s + 2] = figure3.spare[root + 2];
      const colour = figure3.spanAt(figure3.recordedFrame(time))?.colour ?? plain3;
      const last3 = runs.at(-1);
      if (last3?.colour === colour) last3.to = s;
      else runs.push({ from: Math.max(s - 1, 0), to: s, colour });
    }
    return { points, runs, n };
  }
  var PathPainter = class {
    constructor() {
      this.x = new Float32Array(MOST_POINTS);
      this.y = new Float32Array(MOST_POINTS);
      this.scale = new Float32Array(MOST_POINTS);
      this.depth = new Float32Array(MOST_POINTS);
    }
    /**
     * @param {CanvasRenderingContext2D} context
     * @param {Camera} camera
     * @param {Figure[]} figures
     * @param {number} duration
     */
    paint(context, camera, figures, duration) {
      context.lineCap = context.lineJoin = "round";
      for (const figure3 of figures) {
        if (!figure3.visible || !figure3.spans.length || figure3.walksInPlace) continue;
        const { points, runs, n } = figure3.path ??= makePath(figure3, duration, figure3.shades.fill[2][4]);
        camera.project(points, n, this.x, this.y, this.scale, this.depth);
        for (const { from, to, colour } of runs) {
          context.strokeStyle = colour;
          context.lineWidth = Math.min(Math.max(0.035 * this.scale[from], 2), 7);
          context.beginPath();
          for (let s = from; s <= to; s++) if (this.depth[s] > NEAR) context.lineTo(this.x[s], this.y[s]);
          context.stroke();
        }
      }
    }
  };

  // stage/figure.mjs
  var RADII = {
    pelvis: 0.062,
    spine: 0.062,
    chest: 0.058,
    neck: 0.034,
    head: 0.03,
    clavicle: 0.04,
    shoulder: 0.041,
    elbow: 0.031,
    wrist: 0.022,
    hand: 0.013,
    hip: 0.055,
    knee: 0.041,
    ankle: 0.027,
    toe: 0.023,
    foot: 0.017
  };
  var SIDES = { left: 0, right: 1, centre: 2 };
  var TRUNK = /* @__PURE__ */ new Set(["pelvis", "spine", "chest", "neck", "head", "clavicle", ""]);
  var NO_SHADES = { ball: () => document.createElement("canvas"), fill: [], edge: [], sheen: [], light: [] };
  var Figure = class {
    /** @param {Item} item @param {Motion} motion @param {number} index */
    constructor(item, motion, index) {
      const { header, positions } = motion;
      this.item = item;
      this.header = header;
      this.positions = positions;
      this.index = index;
      this.label = item.label || header.clip;
      this.frames = header.frames;
      this.fps = header.fps;
      this.ownFps = header.fps * header.step;
      this.n = header.joints.length;
      this.visible = true;
      this.warp = usableWarp(item.warp ?? void 0);
      this.warpFps = 0;
      this.stretch = 0;
      this.offset = 0;
      this.spans = readSpans(item.colours, header);
      this.yaw = [1, 0];
      this.origin = [0, 0, 0];
      this.place = [0, 0];
      this.level = 0;
      this.walksInPlace = false;
      this.room = Infinity;
      this.path = null;
      this.name = this.label;
      this.brief = this.label;
      this.heading = 0;
      this.colours = [];
      this.shades = NO_SHADES;
      this.points = new Float32Array(3 * this.n);
      this.spare = new Float32Array(3 * this.n);
      this.x = new Float32Array(this.n);
      this.y = new Float32Array(this.n);
      this.scale = new Float32Array(this.n);
      this.depth = new Float32Array(this.n);
      this.size = header.height > 0 ? header.height / 1.75 : 1;
      this.sides = Uint8Array.from(header.sides, (side) => SIDES[side] ?? 2);
      this.radii = Float32Array.from(header.roles, (role) => (RADII[role.split("_").pop() ?? ""] ?? 0.02) * this.size);
      this.limbs = makeLimbs(header, this.sides);
      this.stand();
    }
    get duration() {
      return this.warp && this.warpFps ? (this.warp.length - 1) / this.warpFps : this.ownDuration;
    }
    get ownDuration() {
      return (this.frames - 1) / this.fps;
    }
    /**
     * Follow the medoid's frames at this rate; 0: run at the motion's own pace, or spread over `stretch` seconds.
     * @param {number} medoidFps
     * @param {number} [stretch]
     */
    follow(medoidFps, stretch = 0) {
      this.warpFps = medoidFps;
      this.stretch = stretch;
      this.offset = 0;
    }
    /**
     * Frame (a fraction, among the frames received) at a time in seconds of the stage.
     * @param {number} time
     */
    frameAt(time) {
      return Math.min(Math.max(this.ledTo(time) + this.offset, 0), this.frames - 1);
    }
    /** @param {number} time */
    ledTo(time) {
      if (!this.warp || !this.warpFps) return this.stretch ? time / this.stretch * (this.frames - 1) : time * this.fps;
      const at3 = Math.min(time * this.warpFps, this.warp.length - 1);
      const k = Math.min(Math.floor(at3), this.warp.length - 2);
      const own2 = k < 0 ? this.warp[0] : this.warp[k] + (this.warp[k + 1] - this.warp[k]) * (at3 - k);
      return own2 / this.header.step;
    }
    /**
     * Time in seconds of the stage at which a frame of the recording is reached; the end where it never is.
     * @param {number} recorded
     */
    timeAt(recorded) {
      const frame = Math.min((recorded - this.header.start) / this.header.step, this.frames - 1);
      let [low, high] = [0, this.stretch || this.duration];
      for (let k = 0; k < 40; k++) {
        const middle = (low + high) / 2;
        if (this.frameAt(middle) < frame) low = middle;
        else high = middle;
      }
      return high;
    }
    /**
     * The coloured span that holds a frame of the recording.
     * @param {number} recorded
     */
    spanAt(recorded) {
      return this.spans.find((span) => span.start <= recorded && recorded < span.end);
    }
    /**
     * Number of a frame in the recording itself.
     * @param {number} time
     */
    recordedFrame(time) {
      return Math.round(this.header.start + this.frameAt(time) * this.header.step);
    }
    /**
     * Joints at a time, in the stage's frame, written into `out` (3 n) or the figure's own points.
     * @param {number} time
     * @param {Float32Array} [out]
     */
    pose(time, out = this.points) {
      const at3 = this.frameAt(time);
      const first = Math.floor(at3);
      const next2 = Math.min(first + 1, this.frames - 1);
      const t = at3 - first;
      const [a, b, n, from] = [3 * this.n * first, 3 * this.n * next2, 3 * this.n, this.positions];
      const [cos, sin] = this.yaw;
      const root = 3 * this.header.root;
      const still = this.walksInPlace;
      const ox = still ? from[a + root] + (from[b + root] - from[a + root]) * t : this.origin[0];
      const oz = still ? from[a + root + 2] + (from[b + root + 2] - from[a + root + 2]) * t : this.origin[2];
      for (let k = 0; k < n; k += 3) {
        const x = from[a + k] + (from[b + k] - from[a + k]) * t - ox;
        const z = from[a + k + 2] + (from[b + k + 2] - from[a + k + 2]) * t - oz;
        out[k] = cos * x + sin * z + this.place[0];
        out[k + 1] = from[a + k + 1] + (from[b + k + 1] - from[a + k + 1]) * t - this.origin[1] + this.level;
        out[k + 2] = cos * z - sin * x + this.place[1];
      }
      return out;
    }
    /**
     * Put a frame's root (the first's) at the origin, facing +Z, feet on the floor.
     * @param {number} [frame]
     */
    stand(frame = 0) {
      const first = Math.min(Math.max(Math.floor(frame), 0), this.frames - 1);
      const root = 3 * (first * this.n + this.header.root);
      this.origin = [this.positions[root], this.header.floor || 0, this.positions[root + 2]];
      const [x, z] = this.facing(first);
      const length = Math.hypot(x, z);
      this.heading = length > 1e-3 ? Math.atan2(-x, z) : 0;
      this.turn(0);
    }
    /**
     * Turn to the left of +Z by so many radians.
     * @param {number} angle
     */
    turn(angle) {
      this.yaw = [Math.cos(this.heading + angle), Math.sin(this.heading + angle)];
    }
    /**
     * Where the trunk faces over a fifth of a second from a frame on, on the ground.
     * @param {number} first
     */
    facing(first) {
      const role = (name) => this.header.roles.indexOf(name);
      const pairs = [["left_hip", "right_hip"], ["left_shoulder", "right_shoulder"]];
      let [x, z] = [0, 0];
      const end = Math.min(this.frames, first + 1 + Math.round(this.fps / 5));
      for (const [left, right] of pairs.map((pair) => pair.map(role))) {
        if (left < 0 || right < 0) continue;
        for (let f = first; f < end; f++) {
          const [l, r] = [3 * (f * this.n + left), 3 * (f * this.n + right)];
          x -= this.positions[l + 2] - this.positions[r + 2];
          z += this.positions[l] - this.positions[r];
        }
      }
      return [x, z];
    }
    /**
     * Space the motion takes between two times when it starts at the origin: [min x, max x, min z, max z, max y].
     * @param {number} [from]
     * @param {number} [to]
     * @param {number} [samples]
     */
    extent(from = 0, to = this.duration, samples = 32) {
      const box4 = [0, 0, 0, 0, 0];
      const points = this.spare;
      for (let s = 0; s < samples; s++) {
        this.pose(from + (to - from) * s / Math.max(samples - 1, 1), points);
        for (let k = 0; k < points.length; k += 3) {
          const [x, z] = [points[k] - this.place[0], points[k + 2] - this.place[1]];
          box4[0] = Math.min(box4[0], x);
          box4[1] = Math.max(box4[1], x);
          box4[2] = Math.min(box4[2], z);
          box4[3] = Math.max(box4[3], z);
          box4[4] = Math.max(box4[4], points[k + 1]);
        }
      }
      return box4;
    }
  };
  function usableWarp(warp) {
    if (!warp || warp.length < 2) return null;
    const frames = Float32Array.from(warp);
    return frames.every(Number.isFinite) ? frames : null;
  }
  function makeLimbs(header, sides) {
    const { parents, roles, head: head3, nose } = header;
    const part2 = (j) => roles[j].split("_").pop() ?? "";
    const known4 = roles.some((role) => role === "left_knee");
    const limbs = [];
    const limbOf2 = new Array(parents.length).fill(-1);
    const start3 = (side) => limbs.push({ side, bones: [], joints: [] }) - 1;
    parents.forEach((parent, j) => {
      if (parent < 0 || j === head3 || j === nose) return;
      const inTrunk = known4 && TRUNK.has(part2(j)) && TRUNK.has(part2(parent));
      const toHip = known4 && (part2(j) === "hip" || part2(j) === "shoulder");
      if (!known4) limbOf2[j] = start3(sides[j]);
      else if (inTrunk || toHip) limbOf2[j] = limbs.findIndex((limb) => limb.trunk);
      else limbOf2[j] = limbOf2[parent] >= 0 && !limbs[limbOf2[parent]].trunk ? limbOf2[parent] : start3(sides[j]);
      if (limbOf2[j] < 0) {
        limbOf2[j] = start3(2);
        limbs[limbOf2[j]].trunk = true;
      }
      limbs[limbOf2[j]].bones.push(parent, j);
    });
    for (const limb of limbs) limb.joints = [...new Set(limb.bones)];
    const flanks = ["left_shoulder", "left_hip", "right_shoulder", "right_hip"].map((role) => roles.indexOf(role));
    const trunk2 = limbs.find((limb) => limb.trunk);
    if (trunk2 && Math.min(...flanks) >= 0) trunk2.flanks = flanks;
    return limbs;
  }

  // stage/motion.mjs
  var CACHE_BYTES = 96 * 1024 * 1024;
  var COLUMNS = [["dataset", "dataset"], ["v", "version"], ["clip", "clip"], ["start", "start"], ["end", "end"]];
  var LONGEST_ADDRESS = 6e3;
  function segmentOf(request5, item) {
    const dataset2 = String(item.dataset ?? request5.dataset ?? "");
    const version = String(((item.dataset ?? null) === null ? item.version ?? request5.version : item.version) ?? "");
    const segment = { dataset: dataset2, version, clip: String(item.clip), start: item.start ?? "", end: item.end ?? "" };
    return { ...segment, key: JSON.stringify(Object.values(segment)), permanent: version !== "" || dataset2.startsWith("~") };
  }
  function addresses(api, segments) {
    const query2 = new URLSearchParams();
    const column = (name, values) => new Set(values).size === 1 && name !== "clip" ? query2.set(name, values[0]) : values.forEach((value) => query2.append(name, value));
    for (const [name, key] of COLUMNS) {
      column(name, segments.map((segment) => String(segment[key])));
    }
    const address3 = `${api}/motions?${query2}`;
    if (address3.length <= LONGEST_ADDRESS || segments.length === 1) return [[address3, segments]];
    const half = segments.length >> 1;
    return [...addresses(api, segments.slice(0, half)), ...addresses(api, segments.slice(half))];
  }
  function readHeader(buffer) {
    const length = new DataView(buffer).getUint32(0, true);
    return [JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length))), 4 + length];
  }
  function decode(buffer) {
    const [header, at3] = readHeader(buffer);
    return { header, positions: new Float32Array(buffer, at3, header.frames * header.joints.length * 3), bytes: buffer.byteLength };
  }
  function decodeParts(buffer) {
    const [{ parts: parts2 }, begin3] = readHeader(buffer);
    let at3 = begin3;
    return parts2.map(
      /** @param {{ error?: string, bytes: number }} part */
      ({ error, bytes: bytes2 }) => {
        if (error) return new Error(error);
        at3 += bytes2;
        return decode(buffer.slice(at3 - bytes2, at3));
      }
    );
  }
  async function ask(url) {
    let response;
    try {
      response = await fetch(url);
    } catch {
      throw new Error("The server cannot be reached. Is Motionscape still running?");
    }
    if (response.ok) return decodeParts(await response.arrayBuffer());
    const answer2 = await response.json().catch(() => ({}));
    throw new Error(answer2.error || `The server answered with an error (${response.status}).`);
  }
  var MotionCache = class {
    /** @param {number} [limit] */
    constructor(limit = CACHE_BYTES) {
      this.limit = limit;
      this.bytes = 0;
      this.motions = /* @__PURE__ */ new Map();
      this.coming = /* @__PURE__ */ new Map();
    }
    /**
     * The motions of a request's items, in their order: each a motion or an Error in plain words. Never rejects. A data
     * set's name may come to stand for other content, so the server is asked again unless the segment is for good.
     * @param {string} api
     * @param {StageRequest} request
     * @param {Item[]} items
     */
    load(api, request5, items) {
      const segments = items.map((item) => segmentOf(request5, item));
      const wanted2 = /* @__PURE__ */ new Map();
      for (const segment of segments) {
        const { key, permanent } = segment;
        if (permanent && (this.motions.has(key) || this.coming.has(key))) continue;
        wanted2.set(key, segment);
      }
      if (wanted2.size) this.fetch(addresses(api, [...wanted2.values()]));
      return Promise.all(segments.map(({ key }) => this.coming.get(key) ?? this.keep(
        key,
        /** @type {Motion} */
        this.motions.get(key)
      )));
    }
    /** @param {[string, Segment[]][]} batches */
    fetch(batches) {
      for (const [address3, segments] of batches) {
        const answer2 = ask(address3).catch((error) => segments.map(() => error));
        segments.forEach(({ key }, k) => {
          const motion = answer2.then((motions2) => {
            if (this.coming.get(key) === motion) this.coming.delete(key);
            return motions2[k] instanceof Error ? motions2[k] : this.keep(key, motions2[k]);
          });
          this.coming.set(key, motion);
        });
      }
    }
    /** @param {string} key @param {Motion} motion */
    keep(key, motion) {
      this.bytes += motion.bytes - (this.motions.get(key)?.bytes ?? 0);
      this.motions.delete(key);
      this.motions.set(key, motion);
      for (const [oldest, { bytes: bytes2 }] of this.motions) {
        if (this.bytes <= this.limit || oldest === key) break;
        this.motions.delete(oldest);
        this.bytes -= bytes2;
      }
      return motion;
    }
  };

  // stage/requests.mjs
  var MOST_FIGURES = 48;
  var Requests = class {
    /** @param {Stage} stage */
    constructor(stage2) {
      this.stage = stage2;
      this.cache = new MotionCache();
      this.next = null;
      this.replacing = null;
      this.turn = 0;
    }
    /**
     * Fetch what a request needs, so that showing it later costs nothing.
     * @param {StageRequest} request
     */
    prefetch(request5) {
      const items = (request5?.items ?? []).slice(0, MOST_FIGURES);
      return this.cache.load(this.api, request5, items);
    }
    get api() {
      return this.stage.root.dataset.api || "/api";
    }
    /**
     * Show a request from its start.
     * @param {StageRequest | null} request
     */
    async show(request5) {
      const { stage: stage2 } = this;
      const turn5 = ++this.turn;
      this.next = null;
      stage2.request = request5;
      if (!request5?.items?.length) {
        stage2.setFigures([]);
        return stage2.setStatus("empty");
      }
      const n = Math.min(request5.items.length, MOST_FIGURES);
      stage2.setStatus("loading", n > 1 ? `Loading ${n} motions …` : "Loading …");
      const { figures, failed: failed2 } = await this.figures(request5);
      if (turn5 !== this.turn || stage2.closed) return void 0;
      if (!figures.length) {
        stage2.setFigures([]);
        return stage2.setStatus("error", failed2[0].message);
      }
      stage2.begin(figures, request5);
      return this.notice(request5, n, failed2);
    }
    /**
     * Put other motions in place of those that are shown; time (as a share), camera, layout and what plays stay. While
     * one is being loaded only the newest waits, so that a slider may call this for every step.
     * @param {StageRequest} request
     */
    replace(request5) {
      const { stage: stage2 } = this;
      if (stage2.status !== "ready" || !request5?.items?.length) return this.show(request5);
      this.next = request5;
      return this.replacing ??= this.replaceAll().finally(() => this.replacing = null);
    }
    async replaceAll() {
      const { stage: stage2, turn: turn5 } = this;
      while (this.next && turn5 === this.turn && !stage2.closed) {
        const request5 = this.next;
        this.next = null;
        const { figures, failed: failed2 } = await this.figures(request5);
        if (turn5 !== this.turn || stage2.closed) return;
        stage2.request = request5;
        if (figures.length) stage2.exchange(figures);
        this.notice(request5, Math.min(request5.items.length, MOST_FIGURES), failed2);
      }
    }
    /** @param {StageRequest} request */
    async figures(request5) {
      const items = request5.items.slice(0, MOST_FIGURES);
      const motions2 = await this.cache.load(this.api, request5, items);
      return {
        figures: items.flatMap((item, k) => motions2[k] instanceof Error ? [] : [new Figure(
          { ...item, dataset: item.dataset ?? request5.dataset ?? void 0 },
          motions2[k],
          k
        )]),
        failed: motions2.filter((motion) => motion instanceof Error)
      };
    }
    /**
     * Tell what is missing, without hiding what is there.
     * @param {StageRequest} request
     * @param {number} n
     * @param {Error[]} failed
     */
    notice(request5, n, failed2) {
      const missing = failed2.length ? `${failed2.length} of ${n} motions could not be loaded: ${failed2[0].message}` : "";
      const cut = request5.items.length > n ? `Showing ${n} of ${request5.items.length} motions.` : "";
      const note = within(this.stage.root, ".ms-stage-note");
      within(note, "span").textContent = [missing, cut].filter(Boolean).join(" ");
      note.hidden = !missing && !cut;
      within(note, "button").hidden = !missing;
    }
  };

  // stage/body.mjs
  var corners = (n) => Array.from({ length: n }, (_, k) => -Math.PI / 2 + Math.PI * (k + 0.5) / n);
  var [COARSE, FINE] = [3, 7].map((n) => ({ n, sin: corners(n).map(Math.sin), cos: corners(n).map(Math.cos) }));
  var FINE_FROM = 7;
  var CIRCLE = Array.from({ length: 24 }, (_, k) => [Math.cos(k * Math.PI / 12), Math.sin(k * Math.PI / 12)]);
  function capsule(context, x1, y1, r1, x2, y2, r2) {
    let dx = x2 - x1;
    let dy = y2 - y1;
    const length = Math.sqrt(dx * dx + dy * dy);
    if (length < 0.5) {
      disc(context, x1, y1, Math.max(r1, r2));
      return;
    }
    dx /= length;
    dy /= length;
    const { n, sin, cos } = r1 + r2 > 2 * FINE_FROM ? FINE : COARSE;
    context.beginPath();
    for (let k = 0; k < n; k++) {
      const along2 = r2 * cos[k];
      const across = r2 * sin[k];
      context.lineTo(x2 + along2 * dx - across * dy, y2 + along2 * dy + across * dx);
    }
    for (let k = n - 1; k >= 0; k--) {
      const along2 = -r1 * cos[k];
      const across = r1 * sin[k];
      context.lineTo(x1 + along2 * dx - across * dy, y1 + along2 * dy + across * dx);
    }
    context.fill();
  }
  function disc(context, x, y, r) {
    context.beginPath();
    for (let k = 0; k < CIRCLE.length; k++) context.lineTo(x + r * CIRCLE[k][0], y + r * CIRCLE[k][1]);
    context.fill();
  }
  var HEAD = -1;
  var NOSE = -2;
  var BodyPainter = class {
    constructor() {
      this.items = [];
      this.owners = [];
      this.girth = 1;
      this.headSize = 1;
      this.detailed = true;
      this.outlined = true;
    }
    /**
     * Call when the set of visible figures changes. Many bodies in one place are drawn slender, or none is seen.
     * @param {Figure[]} figures
     * @param {boolean} overlaid
     */
    collect(figures, overlaid) {
      this.items = [];
      this.owners = figures.filter((figure3) => figure3.visible);
      for (const figure3 of this.owners) {
        figure3.limbs.forEach((_, limb) => this.items.push({ figure: figure3, limb, depth: 0 }));
        if (figure3.header.head >= 0) this.items.push({ figure: figure3, limb: HEAD, depth: 0 });
        if (figure3.header.nose >= 0) this.items.push({ figure: figure3, limb: NOSE, depth: 0 });
      }
      const crowd = overlaid ? this.owners.length : 1;
      this.girth = crowd > 8 ? 0.5 : crowd > 4 ? 0.62 : crowd > 1 ? 0.78 : 1;
      this.headSize = 0.3 + 0.7 * this.girth;
      this.detailed = this.owners.length <= 8;
      this.outlined = this.owners.length <= 16;
    }
    sort() {
      const items = this.items;
      for (const item of items) item.depth = depthOf(item);
      for (let i = 1; i < items.length; i++) {
        const item = items[i];
        let j = i - 1;
        for (; j >= 0 && items[j].depth < item.depth; j--) items[j + 1] = items[j];
        items[j + 1] = item;
      }
    }
    /** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {number} reach */
    paint(context, camera, reach) {
      this.sort();
      const levels = FOG_LEVELS;
      for (const { figure: figure3, limb, depth: depth2 } of this.items) {
        if (depth2 < NEAR) continue;
        const far = (depth2 - camera.distance + reach) / (2 * reach);
        const level = Math.min(Math.max(Math.round(far * (levels - 1)), 0), levels - 1);
        if (limb === HEAD) this.paintHead(context, figure3, level);
        else if (limb === NOSE) this.paintNose(context, figure3, level);
        else this.paintLimb(context, figure3, figure3.limbs[limb], level);
      }
    }
    /** @param {CanvasRenderingContext2D} context @param {Figure} figure @param {Limb} limb @param {number} level */
    paintLimb(context, figure3, limb, level) {
      const { shades: shades2 } = figure3;
      if (this.outlined) {
        context.fillStyle = shades2.edge[limb.side][level];
        this.bones(context, figure3, limb.bones, 1);
        if (limb.flanks) this.bones(context, figure3, limb.flanks, 1);
      }
      context.fillStyle = shades2.fill[limb.side][level];
      if (limb.flanks) this.plate(context, figure3, limb.flanks);
      this.bones(context, figure3, limb.bones, 0);
      if (!this.detailed) return;
      if (limb.flanks) {
        context.fillStyle = shades2.sheen[limb.side][level];
        this.sheen(context, figure3, limb.flanks);
        return;
      }
      context.fillStyle = shades2.light[limb.side][level];
      this.highlights(context, figure3, limb.bones);
    }
    /**
     * Each bone as a capsule; `line`: pixels of outline around it.
     * @param {CanvasRenderingContext2D} context
     * @param {Figure} figure
     * @param {number[]} bones
     * @param {number} line
     */
    bones(context, figure3, bones, line3) {
      const { x, y, scale: scale3, radii } = figure3;
      for (let k = 0; k < bones.length; k += 2) {
        const a = bones[k];
        const b = bones[k + 1];
        const around3 = line3 && line3 + 3e-3 * scale3[a];
        const ra = radii[a] * this.girth * scale3[a] + around3;
        capsule(context, x[a], y[a], ra, x[b], y[b], radii[b] * this.girth * scale3[b] + around3);
      }
    }
    /**
     * The chest and belly between two flanks, shoulder to hip.
     * @param {CanvasRenderingContext2D} context
     * @param {Figure} figure
     * @param {number[]} flanks
     */
    plate(context, figure3, flanks) {
      const { x, y } = figure3;
      this.bones(context, figure3, flanks, 0);
      context.beginPath();
      context.moveTo(x[flanks[0]], y[flanks[0]]);
      context.lineTo(x[flanks[1]], y[flanks[1]]);
      context.lineTo(x[flanks[3]], y[flanks[3]]);
      context.lineTo(x[flanks[2]], y[flanks[2]]);
      context.fill();
    }
    /**
     * A band down the side of the trunk that faces the light, which comes from the upper left.
     * @param {CanvasRenderingContext2D} context
     * @param {Figure} figure
     * @param {number[]} flanks
     */
    sheen(context, { x, y }, flanks) {
      const across = x[flanks[0]] < x[flanks[2]] ? 0.08 : 0.5;
      const at3 = (k, share2) => context.lineTo(
        x[flanks[k]] + (x[flanks[k + 2]] - x[flanks[k]]) * share2,
        y[flanks[k]] + (y[flanks[k + 2]] - y[flanks[k]]) * share2
      );
      context.beginPath();
      at3(0, across);
      at3(0, across + 0.42);
      at3(1, across + 0.42);
      at3(1, across);
      context.fill();
    }
    /** @param {CanvasRenderingContext2D} context @param {Figure} figure @param {number[]} bones */
    highlights(context, figure3, bones) {
      const { x, y, scale: scale3, radii } = figure3;
      for (let k = 0; k < bones.length; k += 2) {
        const a = bones[k];
        const b = bones[k + 1];
        const ra = radii[a] * this.girth * scale3[a];
        const rb = radii[b] * this.girth * scale3[b];
        capsule(context, x[a] - 0.32 * ra, y[a] - 0.32 * ra, 0.34 * ra, x[b] - 0.32 * rb, y[b] - 0.32 * rb, 0.34 * rb);
      }
    }
    /** @param {CanvasRenderingContext2D} context @param {Figure} figure @param {number} level */
    paintHead(context, figure3, level) {
      const { header, shades: shades2 } = figure3;
      const [x, y] = [figure3.x[header.head], figure3.y[header.head]];
      const scale3 = figure3.scale[header.head];
      const r = header.head_radius * this.headSize * scale3;
      if (this.outlined) {
        context.fillStyle = shades2.edge[2][level];
        disc(context, x, y, r + 1 + 3e-3 * scale3);
      }
      if (this.detailed) {
        context.drawImage(shades2.ball(level), x - r, y - r, 2 * r, 2 * r);
        return;
      }
      context.fillStyle = shades2.fill[2][level];
      disc(context, x, y, r);
    }
    /**
     * A small cone from the face to the tip.
     * @param {CanvasRenderingContext2D} context
     * @param {Figure} figure
     * @param {number} level
     */
    paintNose(context, figure3, level) {
      const { header, shades: shades2, x, y, scale: scale3 } = figure3;
      const { head: h, nose: t } = header;
      const r = header.head_radius * this.headSize * scale3[h];
      const out = 1.18 * this.headSize;
      const fx = x[h] + 0.7 * this.headSize * (x[t] - x[h]);
      const fy = y[h] + 0.7 * this.headSize * (y[t] - y[h]);
      const tx = x[h] + out * (x[t] - x[h]);
      const ty = y[h] + out * (y[t] - y[h]);
      context.fillStyle = shades2.edge[2][level];
      capsule(context, fx, fy, 0.27 * r + 1, tx, ty, 0.12 * r + 1);
      context.fillStyle = shades2.light[2][level];
      capsule(context, fx, fy, 0.27 * r, tx, ty, 0.12 * r);
    }
  };
  function depthOf({ figure: figure3, limb }) {
    const { depth: depth2, header } = figure3;
    if (limb === HEAD) return depth2[header.head];
    if (limb === NOSE) return depth2[header.nose];
    const joints = figure3.limbs[limb].joints;
    let [sum2, near] = [0, Infinity];
    for (let k = 0; k < joints.length; k++) {
      const d = depth2[joints[k]];
      sum2 += d;
      if (d < near) near = d;
    }
    return near < NEAR ? 0 : sum2 / joints.length;
  }

  // stage/ground.mjs
  var LIGHT = [0.28, -0.22];
  var SHELF_DEPTH = 0.5;
  var ROUND = Array.from({ length: 72 }, (_, k) => [Math.cos(k * Math.PI / 36), Math.sin(k * Math.PI / 36)]);
  var Ground = class {
    constructor() {
      this.radius = 3;
      this.shelves = [];
      this.corners = new Float32Array(3 * 74);
      this.world = new Float32Array(6);
      this.x = new Float32Array(74);
      this.y = new Float32Array(74);
      this.scale = new Float32Array(74);
      this.depth = new Float32Array(74);
      this.sx = new Float32Array(256);
      this.sy = new Float32Array(256);
      this.ss = new Float32Array(256);
      this.sd = new Float32Array(256);
      this.flat = new Float32Array(3 * 256);
    }
    /** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Theme} theme */
    paint(context, camera, theme) {
      if (this.shelves.length) {
        for (const shelf of this.shelves) this.paintShelf(context, camera, theme, shelf);
        return;
      }
      const [cx, cz] = [camera.target[0], camera.target[2]];
      context.fillStyle = theme.floorCss;
      if (this.platform(context, camera, cx, cz, this.radius)) context.fill();
      context.strokeStyle = theme.rimCss;
      context.lineWidth = 1.25;
      context.stroke();
    }
    /**
     * Outline of the platform as a path, cut off where it would lie behind the camera.
     * @param {CanvasRenderingContext2D} context
     * @param {Camera} camera
     * @param {number} cx
     * @param {number} cz
     * @param {number} radius
     */
    platform(context, camera, cx, cz, radius) {
      let n = 0;
      const points = this.corners;
      const last3 = ROUND.length - 1;
      let [px, pz] = [cx + radius * ROUND[last3][0], cz + radius * ROUND[last3][1]];
      let before2 = camera.depth(px, 0, pz) - 2 * NEAR;
      for (const [cos, sin] of ROUND) {
        const [x, z] = [cx + radius * cos, cz + radius * sin];
        const here3 = camera.depth(x, 0, z) - 2 * NEAR;
        if (here3 * before2 < 0) {
          const t = before2 / (before2 - here3);
          points[3 * n] = px + (x - px) * t;
          points[3 * n + 2] = pz + (z - pz) * t;
          n++;
        }
        if (here3 >= 0) {
          points[3 * n] = x;
          points[3 * n + 2] = z;
          n++;
        }
        [px, pz, before2] = [x, z, here3];
      }
      context.beginPath();
      if (n < 3) return false;
      camera.project(points, n, this.x, this.y, this.scale, this.depth);
      for (let k = 0; k < n; k++) context.lineTo(this.x[k], this.y[k]);
      context.closePath();
      return true;
    }
    /**
     * A board across the view under a row of stills.
     * @param {CanvasRenderingContext2D} context
     * @param {Camera} camera
     * @param {Theme} theme
     * @param {Shelf} shelf
     */
    paintShelf(context, camera, theme, { level, half }) {
      [[-half, SHELF_DEPTH], [half, SHELF_DEPTH], [half, -SHELF_DEPTH], [-half, -SHELF_DEPTH]].forEach(([x, z], k) => {
        this.corners.set([x, level, z], 3 * k);
      });
      camera.project(this.corners, 4, this.x, this.y, this.scale, this.depth);
      if (Math.min(...this.depth.subarray(0, 4)) < NEAR) return;
      context.beginPath();
      for (let k = 0; k < 4; k++) context.lineTo(this.x[k], this.y[k]);
      context.closePath();
      context.fillStyle = theme.floorCss;
      context.fill();
      context.strokeStyle = theme.rimCss;
      context.lineWidth = 1.25;
      context.stroke();
    }
    /** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Theme} theme */
    paintGrid(context, camera, theme) {
      if (this.shelves.length) return;
      const [cx, cz] = [camera.target[0], camera.target[2]];
      const step3 = this.radius > 9 ? 2 : this.radius > 4 ? 1 : 0.5;
      context.strokeStyle = theme.gridCss;
      context.lineWidth = 1;
      context.beginPath();
      for (let k = Math.ceil((cx - this.radius) / step3); k * step3 < cx + this.radius; k++) {
        const half = Math.sqrt(Math.max(this.radius ** 2 - (k * step3 - cx) ** 2, 0));
        this.line(context, camera, k * step3, cz - half, k * step3, cz + half);
      }
      for (let k = Math.ceil((cz - this.radius) / step3); k * step3 < cz + this.radius; k++) {
        const half = Math.sqrt(Math.max(this.radius ** 2 - (k * step3 - cz) ** 2, 0));
        this.line(context, camera, cx - half, k * step3, cx + half, k * step3);
      }
      context.stroke();
    }
    /**
     * @param {CanvasRenderingContext2D} context
     * @param {Camera} camera
     * @param {number} x1
     * @param {number} z1
     * @param {number} x2
     * @param {number} z2
     */
    line(context, camera, x1, z1, x2, z2) {
      const w = this.world;
      let [a, b] = [0, 1];
      const d1 = camera.depth(x1, 0, z1) - 2 * NEAR;
      const d2 = camera.depth(x2, 0, z2) - 2 * NEAR;
      if (d1 < 0 && d2 < 0) return;
      if (d1 < 0) a = d1 / (d1 - d2);
      if (d2 < 0) b = d1 / (d1 - d2);
      w[0] = x1 + (x2 - x1) * a;
      w[2] = z1 + (z2 - z1) * a;
      w[3] = x1 + (x2 - x1) * b;
      w[5] = z1 + (z2 - z1) * b;
      camera.project(w, 2, this.x, this.y, this.scale, this.depth);
      context.moveTo(this.x[0], this.y[0]);
      context.lineTo(this.x[1], this.y[1]);
    }
    /**
     * The figure laid flat along the light; then once more, darker, where it comes close to the floor.
     * @param {CanvasRenderingContext2D} context
     * @param {Camera} camera
     * @param {Figure} figure
     * @param {Theme} theme
     */
    paintShadow(context, camera, figure3, theme) {
      const n = Math.min(figure3.n, 256);
      const { points } = figure3;
      for (let k = 0; k < 3 * n; k += 3) {
        const height = Math.max(points[k + 1] - figure3.level, 0);
        this.flat[k] = points[k] + LIGHT[0] * height;
        this.flat[k + 1] = figure3.level;
        this.flat[k + 2] = points[k + 2] + LIGHT[1] * height;
      }
      camera.project(this.flat, n, this.sx, this.sy, this.ss, this.sd);
      context.fillStyle = theme.shadowCss;
      for (const limb of figure3.limbs) this.shadowLimb(context, camera, figure3, limb.bones, Infinity);
      const { head: head3, head_radius: radius } = figure3.header;
      if (head3 >= 0) {
        const r = radius * this.ss[head3];
        capsule(context, this.sx[head3] - 0.4 * r, this.sy[head3], 0.6 * r, this.sx[head3] + 0.4 * r, this.sy[head3], 0.6 * r);
      }
      context.fillStyle = theme.contactCss;
      for (const limb of figure3.limbs) this.shadowLimb(context, camera, figure3, limb.bones, figure3.level + 0.16 * figure3.size);
    }
    /**
     * @param {CanvasRenderingContext2D} context
     * @param {Camera} camera
     * @param {Figure} figure
     * @param {number[]} bones
     * @param {number} below
     */
    shadowLimb(context, camera, figure3, bones, below) {
      const squash = 0.45 + 0.5 * Math.sin(camera.pitch);
      for (let k = 0; k < bones.length; k += 2) {
        const a = bones[k];
        const b = bones[k + 1];
        if (figure3.points[3 * a + 1] > below || figure3.points[3 * b + 1] > below) continue;
        if (this.sd[a] < NEAR || this.sd[b] < NEAR) continue;
        const ra = figure3.radii[a] * this.ss[a] * squash;
        const rb = figure3.radii[b] * this.ss[b] * squash;
        capsule(context, this.sx[a], this.sy[a], ra, this.sx[b], this.sy[b], rb);
      }
    }
  };

  // stage/scene.mjs
  var [LEAST_LETTERS, MOST_LETTERS] = [11, 26];
  var LABELS_OVERLAID = 3;
  var Scene = class {
    /** @param {HTMLCanvasElement} canvas @param {Theme} theme */
    constructor(canvas, theme) {
      this.canvas = canvas;
      this.context = context2d(canvas, { alpha: false });
      this.ground = new Ground();
      this.bodies = new BodyPainter();
      this.sky = document.createElement("canvas");
      this.labels = /* @__PURE__ */ new Map();
      this.width = this.height = 0;
      this.ratio = 0;
      this.theme = theme;
    }
    /** Match the canvas to its box and the screen's pixels; true when anything changed. */
    resize() {
      const ratio = Math.min(window.devicePixelRatio || 1, 2);
      const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
      const height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
      if (width === this.width && height === this.height && ratio === this.ratio) return false;
      this.canvas.width = this.width = width;
      this.canvas.height = this.height = height;
      this.ratio = ratio;
      this.labels.clear();
      this.paintSky();
      return true;
    }
    /** @param {Theme} theme */
    setTheme(theme) {
      this.theme = theme;
      for (const name of ["floor", "rim", "grid", "shadow", "contact", "text"]) theme[`${name}Css`] = css(theme[name]);
      this.labels.clear();
      this.paintSky();
    }
    paintSky() {
      if (!this.theme || !this.width) return;
      this.sky.width = this.width;
      this.sky.height = this.height;
      const context = context2d(this.sky);
      const gradient = context.createLinearGradient(0, 0, 0, this.height);
      gradient.addColorStop(0, css(this.theme.sky));
      gradient.addColorStop(1, css(this.theme.haze));
      context.fillStyle = gradient;
      context.fillRect(0, 0, this.width, this.height);
    }
    /**
     * @param {Camera} camera
     * @param {Figure[]} figures
     * @param {Traces} traces
     * @param {Clock} clock
     * @param {boolean} overlaid
     */
    paint(camera, figures, traces, clock2, overlaid) {
      const { context, theme } = this;
      camera.prepare(this.width, this.height);
      context.drawImage(this.sky, 0, 0);
      this.ground.paint(context, camera, theme);
      for (const figure3 of figures) {
        if (!figure3.visible) continue;
        camera.project(figure3.points, figure3.n, figure3.x, figure3.y, figure3.scale, figure3.depth);
        this.ground.paintShadow(context, camera, figure3, theme);
      }
      this.ground.paintGrid(context, camera, theme);
      traces.paint(context, camera, figures, clock2);
      this.bodies.paint(context, camera, Math.min(this.ground.radius, 0.8 * camera.distance));
      if (figures.length > 1) this.paintLabels(figures, overlaid);
    }
    /**
     * The visible figure at a place of the picture, in its pixels; undefined where there is none near.
     * @param {Figure[]} figures
     * @param {number} x
     * @param {number} y
     */
    figureAt(figures, x, y) {
      let hit;
      let least = Infinity;
      for (const figure3 of figures) {
        if (!figure3.visible) continue;
        for (let j = 0; j < figure3.n; j++) {
          if (figure3.depth[j] < NEAR) continue;
          const away = Math.hypot(figure3.x[j] - x, figure3.y[j] - y);
          const near = away + 0.02 * figure3.depth[j];
          if (away < Math.max(14 * this.ratio, 0.16 * figure3.scale[j]) && near < least) [hit, least] = [figure3, near];
        }
      }
      return hit;
    }
    /** @param {Figure[]} figures @param {boolean} overlaid */
    paintLabels(figures, overlaid) {
      const shown9 = figures.filter((figure3) => figure3.visible);
      if (overlaid && shown9.length > LABELS_OVERLAID) return;
      const taken = [];
      for (const figure3 of shown9.sort((a, b) => a.depth[a.header.root] - b.depth[b.header.root])) {
        const top = figure3.header.head >= 0 ? figure3.header.head : figure3.header.root;
        if (figure3.depth[top] < NEAR) continue;
        const sprite = this.label(figure3, figure3.room * figure3.scale[top]);
        if (!sprite) continue;
        const room = this.canvas.width - sprite.width;
        if (figure3.x[top] < 0 || figure3.x[top] > this.canvas.width) continue;
        const x = Math.round(Math.min(Math.max(figure3.x[top] - sprite.width / 2, 0), Math.max(room, 0)));
        const highest = figure3.room === Infinity ? figure3.y[top] : Math.min(...figure3.y) + 0.12 * figure3.size * figure3.scale[top];
        let y = Math.round(highest - (0.17 * figure3.size * figure3.scale[top] + 1.2 * sprite.height));
        const hits = (box4) => Math.abs(box4[0] - x) < (box4[2] + sprite.width) / 2 && Math.abs(box4[1] - y) < sprite.height;
        for (let tries = 0; tries < 4 && shown9.length <= 4 && taken.some(hits); tries++) y -= sprite.height + 2;
        if (taken.some(hits) || y < 0) continue;
        taken.push([x, y, sprite.width]);
        this.context.drawImage(sprite, x, y);
      }
    }
    /**
     * A label drawn once: text on a soft plate with the figure's colour, no wider than `room` pixels; or none.
     * @param {Figure} figure
     * @param {number} room
     */
    label(figure3, room) {
      const size = 11.5 * this.ratio;
      const letters2 = Math.min(Math.floor((0.96 * room - 2.1 * size) / (0.56 * size)), MOST_LETTERS);
      const whole3 = letters2 >= Math.min(LEAST_LETTERS, figure3.name.length);
      if (!whole3 && figure3.brief.length > letters2 + 1) return null;
      const text = whole3 ? shorten(figure3.name, letters2) : figure3.brief;
      const key = `${text}|${figure3.shades.fill[2][0]}`;
      if (this.labels.has(key)) return this.labels.get(key);
      const sprite = document.createElement("canvas");
      let context = context2d(sprite);
      const font = `500 ${size}px ${this.theme.font}`;
      context.font = font;
      sprite.width = Math.ceil(context.measureText(text).width + 2.1 * size);
      sprite.height = Math.ceil(1.7 * size);
      context = context2d(sprite);
      context.globalAlpha = 0.82;
      context.fillStyle = css(this.theme.sky);
      context.beginPath();
      context.roundRect(0, 0, sprite.width, sprite.height, sprite.height / 2);
      context.fill();
      context.globalAlpha = 1;
      context.fillStyle = figure3.shades.fill[2][0];
      disc(context, 0.85 * size, sprite.height / 2, 0.32 * size);
      context.font = font;
      context.textBaseline = "middle";
      context.fillStyle = this.theme.textCss;
      context.fillText(text, 1.4 * size, sprite.height / 2 + 0.5);
      this.labels.set(key, sprite);
      return sprite;
    }
  };

  // stage/traces.mjs
  var TRAILS = ["off", "root", "limbs"];
  var GHOST_GAP = 0.22;
  var TRAIL_SECONDS = 1.6;
  var TRAIL_POINTS = 40;
  var Traces = class {
    constructor() {
      this.ghosts = false;
      this.trails = "off";
      this.suited = false;
      this.paths = new PathPainter();
      this.points = new Float32Array(3 * 256);
      this.x = new Float32Array(256);
      this.y = new Float32Array(256);
      this.scale = new Float32Array(256);
      this.depth = new Float32Array(256);
    }
    /**
     * Motions with coloured spans show them on the floor; without them trails are as the person left them.
     * @param {Figure[]} figures
     */
    suit(figures) {
      const coloured = figures.some((figure3) => figure3.spans.length);
      if (coloured && this.trails === "off") [this.trails, this.suited] = ["root", true];
      else if (!coloured && this.suited) [this.trails, this.suited] = ["off", false];
    }
    nextTrails() {
      this.suited = false;
      this.trails = TRAILS[(TRAILS.indexOf(this.trails) + 1) % TRAILS.length];
    }
    /** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Figure[]} figures @param {Clock} clock */
    paint(context, camera, figures, clock2) {
      const shown9 = figures.filter((figure3) => figure3.visible);
      context.lineJoin = "round";
      context.lineCap = "round";
      if (this.trails === "root") this.paths.paint(context, camera, shown9, clock2.duration);
      if (this.trails !== "off") for (const figure3 of shown9) this.paintTrails(context, camera, figure3, clock2);
      if (!this.ghosts || !shown9.length) return;
      const count = Math.min(Math.max(Math.floor(24 / shown9.length), 1), 4);
      for (let g = count; g >= 1; g--) {
        context.globalAlpha = 0.34 * (1 - (g - 1) / (count + 0.5));
        for (const figure3 of shown9) {
          if (clock2.time - g * GHOST_GAP > 0) this.paintGhost(context, camera, figure3, clock2.time - g * GHOST_GAP);
          if (g <= count / 2 && clock2.time + g * GHOST_GAP < clock2.duration) {
            this.paintGhost(context, camera, figure3, clock2.time + g * GHOST_GAP);
          }
        }
      }
      context.globalAlpha = 1;
    }
    /** @param {CanvasRenderingContext2D} context @param {Camera} camera @param {Figure} figure @param {number} time */
    paintGhost(context, camera, figure3, time) {
      if (figure3.n > 256) return;
      figure3.pose(time, this.points);
      camera.project(this.points, figure3.n, this.x, this.y, this.scale, this.depth);
      for (const limb of figure3.limbs) {
        context.strokeStyle = figure3.shades.fill[limb.side][0];
        context.lineWidth = Math.max(1.4 * figure3.radii[limb.bones[1]] * this.scale[limb.bones[0]], 1.5);
        context.beginPath();
        let last3 = -1;
        for (let k = 0; k < limb.bones.length; k += 2) {
          const a = limb.bones[k];
          const b = limb.bones[k + 1];
          if (this.depth[a] < NEAR || this.depth[b] < NEAR) continue;
          if (a !== last3) context.moveTo(this.x[a], this.y[a]);
          context.lineTo(this.x[b], this.y[b]);
          last3 = b;
        }
        context.stroke();
      }
      const { head: head3, head_radius: radius } = figure3.header;
      if (head3 < 0 || this.depth[head3] < NEAR) return;
      context.fillStyle = figure3.shades.fill[2][0];
      disc(context, this.x[head3], this.y[head3], radius * this.scale[head3]);
    }
    /**
     * A ribbon of the last seconds for the root, or for hands and feet.
     * @param {CanvasRenderingContext2D} context
     * @param {Camera} camera
     * @param {Figure} figure
     * @param {Clock} clock
     */
    paintTrails(context, camera, figure3, clock2) {
      const { header } = figure3;
      if (this.trails === "root" && figure3.spans.length) return;
      const feet = header.feet.filter((j) => /_ankle$/.test(header.roles[j]));
      const joints = this.trails === "root" ? [header.root] : [...header.hands, ...feet];
      const from = Math.max(0, clock2.time - TRAIL_SECONDS);
      const n = Math.max(2, Math.ceil(TRAIL_POINTS * (clock2.time - from) / TRAIL_SECONDS));
      const paths = joints.map(() => new Float32Array(3 * n));
      for (let s = 0; s < n; s++) {
        figure3.pose(from + (clock2.time - from) * s / (n - 1), this.points);
        joints.forEach((j, k) => paths[k].set(this.points.subarray(3 * j, 3 * j + 3), 3 * s));
      }
      joints.forEach((j, k) => {
        camera.project(paths[k], n, this.x, this.y, this.scale, this.depth);
        context.strokeStyle = figure3.shades.fill[figure3.sides[j]][0];
        context.lineWidth = 2;
        for (let third = 0; third < 3; third++) {
          context.globalAlpha = 0.25 + 0.3 * third;
          context.beginPath();
          for (let s = Math.floor(n * third / 3); s < Math.min(n, Math.floor(n * (third + 1) / 3) + 1); s++) {
            if (this.depth[s] > NEAR) context.lineTo(this.x[s], this.y[s]);
          }
          context.stroke();
        }
      });
      context.globalAlpha = 1;
    }
  };

  // stage/state.mjs
  var LAYOUTS = ["overlay", "side", "pose"];
  var round = (value) => Math.round(value * 1e3) / 1e3;
  var oneOf = (value, choices2, otherwise) => choices2.includes(value) ? value : otherwise;
  var number = (value, otherwise) => Number.isFinite(value) ? value : otherwise;
  function takeState({ clock: clock2, camera, traces, layout, sync, figures }) {
    return {
      time: round(clock2.time),
      speed: clock2.speed,
      loop: clock2.loop,
      playing: clock2.playing,
      layout,
      sync,
      ghosts: traces.ghosts,
      trails: traces.trails,
      hidden: figures.flatMap((figure3, k) => figure3.visible ? [] : [k]),
      camera: {
        yaw: round(camera.yaw),
        pitch: round(camera.pitch),
        distance: round(camera.distance),
        pan: camera.pan.map(round),
        follow: camera.follow,
        centre: camera.follow ? void 0 : camera.centre.map(round)
      }
    };
  }
  function restoreState(stage2, state3) {
    const { clock: clock2, camera, traces } = stage2;
    stage2.layout = oneOf(state3.layout, LAYOUTS, stage2.layout);
    stage2.sync = oneOf(state3.sync, ["warp", "start"], stage2.sync);
    stage2.figures.forEach((figure3, k) => figure3.visible = !state3.hidden?.includes(k));
    traces.ghosts = Boolean(state3.ghosts ?? traces.ghosts);
    traces.trails = oneOf(state3.trails, TRAILS, traces.trails);
    clock2.speed = Math.min(Math.max(number(state3.speed, clock2.speed), 0.1), 4);
    clock2.loop = oneOf(state3.loop, ["loop", "bounce", "once"], clock2.loop);
    stage2.prepare();
    const seen3 = state3.camera || {};
    camera.moved = Number.isFinite(seen3.distance) || camera.moved;
    for (
      const name of
      /** @type {const} */
      ["yaw", "pitch", "distance"]
    ) camera[name] = number(seen3[name], camera[name]);
    if (seen3.pan?.length === 3 && seen3.pan.every(Number.isFinite)) camera.pan = [...seen3.pan];
    if (seen3.centre?.length === 2 && seen3.centre.every(Number.isFinite)) camera.centre = [...seen3.centre];
    camera.follow = Boolean(seen3.follow ?? camera.follow);
    clock2.seek(number(state3.time, clock2.time));
    clock2.playing = Boolean(state3.playing ?? clock2.playing) && !calm();
  }
  function standing(figure3, time) {
    const frame = figure3.recordedFrame(time);
    const { start: start3, end } = figure3.header;
    return {
      index: figure3.index,
      dataset: figure3.item.dataset,
      clip: figure3.header.clip,
      label: figure3.label,
      start: start3,
      end,
      frame,
      span: figure3.spanAt(frame)?.label ?? null
    };
  }
  function timeOf(figures, { clip, frame, dataset: dataset2, index }) {
    const away = ({ header }) => Math.max(header.start - frame, frame - (header.end - 1), 0);
    const fitting = figures.filter((figure3) => figure3.header.clip === clip && (dataset2 === void 0 || figure3.item.dataset === dataset2) && (index === void 0 || figure3.index === index));
    if (!fitting.length || !Number.isFinite(frame)) return null;
    const rank = (figure3) => away(figure3) + (figure3.visible ? 0 : 0.5);
    return fitting.reduce((best, figure3) => rank(figure3) < rank(best) ? figure3 : best).timeAt(frame);
  }
  var calm = () => window.matchMedia("(prefers-reduced-motion: reduce)").matches;

  // stage/timeline.mjs
  var SPEEDS = [0.1, 0.25, 0.5, 0.75, 1, 1.5, 2, 3, 4];
  var LOOPS = ["loop", "bounce", "once"];
  var Clock = class {
    constructor() {
      this.time = 0;
      this.duration = 0;
      this.speed = 1;
      this.loop = "loop";
      this.playing = false;
      this.direction = 1;
      this.jumped = false;
    }
    /** @param {number} time */
    seek(time) {
      this.time = Math.min(Math.max(time, 0), this.duration);
      this.jumped = true;
    }
    play() {
      if (this.loop === "once" && this.time >= this.duration) this.seek(0);
      this.direction = 1;
      this.playing = this.duration > 0;
    }
    /** @param {number} by */
    changeSpeed(by) {
      const nearest2 = SPEEDS.reduce((best, s, k) => Math.abs(s - this.speed) < Math.abs(SPEEDS[best] - this.speed) ? k : best, 0);
      this.speed = SPEEDS[Math.min(Math.max(nearest2 + by, 0), SPEEDS.length - 1)];
    }
    nextLoop() {
      this.loop = LOOPS[(LOOPS.indexOf(this.loop) + 1) % LOOPS.length];
      this.direction = 1;
    }
    /** @param {number} seconds */
    advance(seconds) {
      if (!this.playing) return;
      let time = this.time + seconds * this.speed * this.direction;
      if (time >= 0 && time <= this.duration) {
        this.time = time;
        return;
      }
      if (this.loop === "loop") {
        this.seek(time % this.duration);
      } else if (this.loop === "bounce") {
        time = time < 0 ? -time : 2 * this.duration - time;
        this.time = Math.min(Math.max(time, 0), this.duration);
        this.direction *= -1;
      } else {
        this.time = this.duration;
        this.playing = false;
      }
    }
  };
  function findMedoid(figures) {
    let best = -1;
    let least = Infinity;
    figures.forEach((figure3, k) => {
      if (!figure3.warp) return;
      const bend = figure3.warp.reduce((sum2, frame, i) => sum2 + Math.abs(frame - i), 0) / figure3.warp.length;
      if (bend < least) [best, least] = [k, bend];
    });
    return best;
  }
  function makeTimeline(figures, sync, layout) {
    const medoid = sync === "warp" ? findMedoid(figures) : -1;
    const reference = medoid < 0 ? longest(figures) : medoid;
    const warped = medoid >= 0;
    figures.forEach((figure3) => figure3.follow(warped && figure3.warp ? figures[medoid].ownFps : 0));
    const chosen3 = figures[reference];
    const spread = layout === "pose" && figures.length > 0;
    const duration = spread ? chosen3.duration : figures.reduce((most, figure3) => Math.max(most, figure3.duration), 0);
    if (spread) figures.forEach((figure3) => spreadOver(figure3, duration));
    return { reference, warped, fps: chosen3 ? chosen3.fps : 30, duration };
  }
  function spreadOver(figure3, duration) {
    figure3.follow(figure3.warpFps, duration);
    const middle = figure3.item.frame;
    if (middle === void 0 || !Number.isFinite(middle)) return;
    const { start: start3, step: step3 } = figure3.header;
    figure3.offset = (middle - start3) / step3 - figure3.frameAt(duration / 2);
  }
  function longest(figures) {
    return figures.reduce((best, f, k) => f.ownDuration > figures[best].ownDuration ? k : best, 0);
  }

  // stage/warp.mjs
  var [SLOW, FAST] = [[33, 102, 172], [230, 97, 1]];
  var LEVELS = 16;
  var RANGE = Math.log(2.5);
  var WarpStrip = class {
    /** @param {HTMLElement} holder */
    constructor(holder) {
      this.holder = holder;
      this.canvas = /** @type {HTMLCanvasElement} */
      /** @type {Element} */
      within(holder, "canvas");
      this.cursor = within(holder, ".ms-warp-cursor");
      this.speeds = [];
      this.figures = [];
      this.rowHeight = 3;
      this.stale = false;
    }
    /**
     * Smoothed speed of each motion relative to the medoid's, one value a medoid frame; none hides the strip.
     * @param {Figure[]} figures
     * @param {Timeline} timeline
     */
    show(figures, timeline) {
      this.speeds = timeline.warped ? figures.filter((f) => f.warp && f.visible).map((f) => localSpeed(f, figures[timeline.reference])) : [];
      this.holder.hidden = this.speeds.length < 2;
      if (this.holder.hidden) return;
      this.figures = figures.filter((f) => f.warp && f.visible);
      this.rowHeight = Math.max(3, Math.min(9, Math.floor(84 / this.speeds.length)));
      this.canvas.style.height = `${this.speeds.length * (this.rowHeight + 1)}px`;
    }
    /** Paint before the next frame: several changes at once cost one painting. */
    paint() {
      this.stale = true;
    }
    /** @param {Theme} theme */
    refresh(theme) {
      if (!this.stale || this.holder.hidden) return;
      this.stale = false;
      const rows2 = this.speeds.length;
      const height = this.rowHeight;
      const ratio = Math.min(window.devicePixelRatio || 1, 2);
      const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
      this.canvas.width = width;
      this.canvas.height = Math.round(rows2 * (height + 1) * ratio);
      const context = context2d(this.canvas);
      const colours = levelColours(theme);
      this.speeds.forEach((speed, row7) => {
        const y = Math.round(row7 * (height + 1) * ratio);
        for (const { from, to, level } of levelRuns(speed, Math.min(width, 400))) {
          context.fillStyle = colours[level + LEVELS];
          context.fillRect(Math.floor(from * width), y, Math.ceil((to - from) * width) + 1, Math.round(height * ratio));
        }
        context.fillStyle = this.figures[row7].shades.fill[2][0];
        context.fillRect(0, y, Math.round(4 * ratio), Math.round(height * ratio));
      });
    }
    /** @param {number} share */
    place(share2) {
      if (!this.holder.hidden) this.cursor.style.left = `${(100 * share2).toFixed(3)}%`;
    }
    /**
     * What the row and column under the pointer mean, in words.
     * @param {PointerEvent} event
     */
    describe(event) {
      const box4 = this.canvas.getBoundingClientRect();
      const row7 = Math.floor((event.clientY - box4.top) / box4.height * this.speeds.length);
      const share2 = (event.clientX - box4.left) / box4.width;
      const speed = this.speeds[row7]?.[Math.floor(share2 * this.speeds[row7].length)];
      if (!(speed > 0)) return "";
      const pace = speed > 1.05 ? `${speed.toFixed(1)}× as fast` : speed < 0.95 ? `${(1 / speed).toFixed(1)}× as slow` : "as fast";
      return `${this.figures[row7].label}: ${pace} as the middle motion here. Click to go there.`;
    }
  };
  function levelColours(theme) {
    const neutral = mix(theme.haze, theme.muted, 0.3);
    return Array.from({ length: 2 * LEVELS + 1 }, (_, k) => {
      const share2 = k / LEVELS - 1;
      return css(mix(neutral, share2 < 0 ? SLOW : FAST, Math.abs(share2)));
    });
  }
  function levelRuns(speed, columns) {
    const runs = [];
    for (let c = 0; c < columns; c++) {
      const share2 = Math.log(Math.max(speed[Math.floor((c + 0.5) * speed.length / columns)], 0.05)) / RANGE;
      const level = Math.round(LEVELS * Math.min(Math.max(share2, -1), 1));
      const last3 = runs.at(-1);
      if (last3?.level === level) last3.to = (c + 1) / columns;
      else runs.push({ from: c / columns, to: (c + 1) / columns, level });
    }
    return runs;
  }
  function localSpeed(figure3, medoid) {
    const warp = figure3.warp ?? new Float32Array(2);
    const reach = Math.max(1, Math.round(0.1 * medoid.ownFps));
    return Float32Array.from(warp, (_, k) => {
      const [a, b] = [Math.max(k - reach, 0), Math.min(k + reach, warp.length - 1)];
      return (warp[b] - warp[a]) / (b - a) * (medoid.ownFps / figure3.ownFps);
    });
  }

  // stage/stage.mjs
  var LAYOUT_WORDS = { overlay: "Overlay", side: "Side by side", pose: "Stills in rows" };
  var Stage = class {
    /** @param {HTMLElement} root */
    constructor(root) {
      this.root = root;
      this.clock = new Clock();
      this.camera = new Camera();
      this.traces = new Traces();
      this.scene = new Scene(
        /** @type {HTMLCanvasElement} */
        /** @type {Element} */
        within(root, `#${STAGE_CANVAS}`),
        readTheme(root)
      );
      this.warpStrip = new WarpStrip(within(root, ".ms-warp"));
      this.bands = new SpanBands(within(root, ".ms-bands"));
      this.requests = new Requests(this);
      this.figures = [];
      this.request = void 0;
      this.timeline = { reference: 0, warped: false, fps: 30, duration: 0 };
      this.layout = "overlay";
      this.sync = "warp";
      this.status = "empty";
      this.chosen = -1;
      this.closed = false;
      this.waiting = void 0;
      this.frames = new Frames(this);
      this.events = new StageEvents(this);
      this.messages = new Messages(root);
      this.controls = new Controls(this, root);
      this.looks = new Looks(this);
      this.readLooks();
      this.setStatus("empty");
      this.frames.start();
    }
    /** Colours and sizes are others: paint with them. */
    readLooks() {
      this.scene.setTheme(readTheme(this.root));
      this.colour();
    }
    resized() {
      if (this.scene.resize()) this.fit();
      this.warpStrip.paint();
      this.draw();
    }
    close() {
      this.closed = true;
      this.looks.close();
    }
    /** Show figures from their start, as a request wants it. @param {Figure[]} figures @param {StageRequest} request */
    begin(figures, request5) {
      this.layout = request5.layout && LAYOUTS.includes(request5.layout) ? request5.layout : "overlay";
      this.sync = request5.sync === "start" ? "start" : "warp";
      this.clock.time = 0;
      this.camera.reset(homeView(figures, this.layout));
      this.traces.suit(figures);
      this.setFigures(figures);
      this.setStatus("ready");
      this.clock.playing = false;
      if (this.layout === "pose") this.standStill();
      else if (!calm()) this.clock.play();
      if (this.waiting) this.restore(this.waiting);
      this.touch(true);
    }
    /**
     * Put other figures in place of those that are shown; what a person has set, and the share of time, stay.
     * @param {Figure[]} figures
     */
    exchange(figures) {
      if (figures.length === this.figures.length) figures.forEach((figure3, k) => figure3.visible = this.figures[k].visible);
      this.keepingShare(() => this.setFigures(figures, true));
      this.setStatus("ready");
      this.touch();
    }
    /** Stills show the middle of each motion, until one moves them. */
    standStill() {
      this.clock.playing = false;
      this.clock.seek(this.clock.duration / 2);
    }
    /** @param {Figure[]} figures @param {boolean} [keepView] */
    setFigures(figures, keepView = false) {
      this.figures = figures;
      nameFigures(figures);
      this.prepare(keepView);
    }
    /** Do what changes the length of time; the clock goes on at the same share of it. @param {() => void} change */
    keepingShare(change2) {
      const { clock: clock2 } = this;
      const share2 = clock2.duration ? clock2.time / clock2.duration : 0;
      change2();
      clock2.seek(share2 * clock2.duration);
    }
    /**
     * Everything that depends on which figures there are, how they are laid out and kept in step.
     * @param {boolean} [keepView]
     */
    prepare(keepView = false) {
      this.timeline = makeTimeline(this.figures, this.sync, this.layout);
      this.clock.duration = this.timeline.duration;
      this.clock.seek(this.clock.time);
      this.showStrips();
      this.place(keepView);
      this.controls.listFigures();
      this.colour();
    }
    /** The strips above the time bar: how fast each motion is, and its coloured spans. */
    showStrips() {
      this.warpStrip.show(this.figures, this.timeline);
      this.warpStrip.paint();
      this.bands.show(this.figures, this.timeline.duration);
    }
    /** @param {boolean} [keepView] */
    place(keepView = false) {
      this.scene.resize();
      const aspect = this.scene.width / Math.max(this.scene.height, 1);
      this.scene.ground.shelves = placeFigures(this.figures, this.layout, aspect, this.clock.duration);
      this.scene.bodies.collect(this.figures, this.layout === "overlay");
      if (!keepView) this.fit();
      this.clock.jumped = true;
      this.draw();
    }
    /** Frame all figures, unless the person has chosen a distance already. */
    fit() {
      if (!this.figures.length) return;
      const { cloud, radius } = measureStage(this.figures, this.clock.duration);
      this.camera.fit(cloud, this.scene.width / Math.max(this.scene.height, 1));
      this.scene.ground.radius = Math.max(2.2, radius * 1.5 + 0.6);
    }
    colour() {
      const { theme } = this.scene;
      this.figures.forEach((figure3, k) => {
        figure3.colours = figureColours(theme, k, this.figures.length, figure3.item.colour);
        figure3.shades = shades(theme, figure3.colours, this.chosen >= 0 && this.chosen !== k ? 0.72 : 0);
      });
      this.controls.colourChips();
      this.warpStrip.paint();
      this.draw();
    }
    /** @param {number} k */
    highlight(k) {
      this.chosen = k;
      this.colour();
    }
    /** Say which figure is under the pointer. @param {number} x @param {number} y */
    pointAt(x, y) {
      const { canvas, ratio } = this.scene;
      const figure3 = this.figures.length > 1 ? this.scene.figureAt(this.figures, x * ratio, y * ratio) : void 0;
      const title = figure3 ? `${figure3.label}, frame ${figure3.recordedFrame(this.clock.time)}` : "";
      if (canvas.title !== title) canvas.title = title;
    }
    /** @param {number} k @param {boolean} visible */
    setVisible(k, visible2) {
      this.figures[k].visible = visible2;
      this.place();
      this.showStrips();
      this.touch(true);
    }
    /** @param {string} layout */
    setLayout(layout) {
      if (this.figures.length < 2) return;
      this.layout = layout;
      this.camera.reset(homeView(this.figures, layout));
      this.keepingShare(() => this.prepare());
      if (layout === "pose") this.standStill();
      this.messages.say(LAYOUT_WORDS[layout]);
    }
    /** @param {string} sync */
    setSync(sync) {
      if (!this.figures.some((figure3) => figure3.warp)) return;
      this.sync = sync;
      this.keepingShare(() => this.prepare());
      this.messages.say(this.timeline.warped ? "In step" : "Each at its own pace");
    }
    play() {
      this.clock.play();
      this.touch(true);
    }
    pause() {
      this.clock.playing = false;
      this.touch(true);
    }
    /**
     * To a time in seconds, or to a frame of a clip: {clip, frame, dataset?, index?}. False where that is not shown.
     * @param {number | Moment | null} to
     */
    seek(to) {
      const time = typeof to === "number" ? to : to ? timeOf(this.figures, to) : null;
      if (time === null || !Number.isFinite(time)) return false;
      this.clock.seek(time);
      this.touch();
      return true;
    }
    /** @param {number} frames */
    step(frames) {
      this.clock.playing = false;
      const { fps } = this.timeline;
      this.seek(Math.round(this.clock.time * fps + frames) / fps);
      this.controls.update();
    }
    resetCamera() {
      this.camera.reset(homeView(this.figures, this.layout));
      this.place();
      this.messages.say("View reset");
    }
    /**
     * Something changed: draw, bring the buttons in line (`byHand`: the person did it), tell the app.
     * @param {boolean} [byHand]
     */
    touch(byHand) {
      if (byHand) this.controls.update();
      this.draw();
      this.events.tellState();
    }
    draw() {
      this.frames.stale = true;
    }
    /** Where every figure stands now. */
    standing() {
      return this.figures.map((figure3) => standing(figure3, this.clock.time));
    }
    /** @param {string} status @param {string} [message] */
    setStatus(status2, message2 = "") {
      this.status = status2;
      this.root.dataset.status = status2;
      this.messages.show(status2 === "empty" ? "" : this.request?.title || this.request?.items[0]?.label || "", message2);
      this.scene.canvas.setAttribute("aria-label", status2 === "ready" ? describe(this.figures) : "Stage for moving figures");
      this.controls.update();
      this.draw();
    }
    state() {
      return takeState(this);
    }
    /** @param {SavedState} state */
    restore(state3) {
      this.waiting = this.status === "ready" ? void 0 : state3;
      if (this.status !== "ready") return;
      restoreState(this, state3);
      this.touch(true);
    }
  };

  // stage/player.mjs
  var stage = null;
  var mounted = null;
  var requestCount = 0;
  var early = null;
  function mount() {
    const root = find(STAGE);
    if (root === mounted) return;
    mounted = root;
    stage?.close();
    stage = null;
    stage = root ? new Stage(root) : null;
    if (stage && early?.request) stage.requests.show(early.request);
    if (stage && early?.state) stage.restore(early.state);
    if (stage) early = null;
  }
  var shown = (request5) => stage !== null && stage.status !== "error" && JSON.stringify(request5) === JSON.stringify(stage.request);
  var player = {
    /**
     * Show a request from its start (`replace: true` in it: as replace does); one that is shown already goes on.
     * @param {StageRequest} request
     */
    show(request5) {
      requestCount += 1;
      mount();
      if (!stage) early = { ...early, request: request5 };
      else if (!shown(request5)) return request5?.replace ? stage.requests.replace(request5) : stage.requests.show(request5);
      return void 0;
    },
    /**
     * Swap the motions in place: the share of time, camera, layout and what plays stay as they are.
     * @param {StageRequest} request
     */
    replace: (request5) => stage ? stage.requests.replace(request5) : player.show(request5),
    /**
     * Fetch a request's motions, so that showing them later is immediate.
     * @param {StageRequest} request
     */
    prefetch: (request5) => stage?.requests.prefetch(request5).then(() => void 0),
    /** How often something was to be shown. */
    get requestCount() {
      return requestCount;
    },
    /** @param {SavedState} state */
    restore(state3) {
      if (!state3) return;
      if (stage) stage.restore(state3);
      else early = { ...early, state: state3 };
    },
    state: () => stage?.state(),
    play: () => stage?.play(),
    pause: () => stage?.pause(),
    /** @param {number | Moment | null} to */
    seek: (to) => stage?.seek(to) ?? false,
    /**
     * Where the figure of an item stands: {index, dataset, clip, label, start, end, frame, span}.
     * @param {number} index
     */
    frameOf: (index) => stage?.standing().find((item) => item.index === index),
    /** Where the figures of all items stand. @returns {Standing[]} */
    standing: () => stage?.standing() ?? [],
    get time() {
      return stage?.clock.time ?? 0;
    },
    get duration() {
      return stage?.clock.duration ?? 0;
    },
    get frame() {
      return stage?.figures.length ? stage.figures[stage.timeline.reference].recordedFrame(stage.clock.time) : 0;
    },
    /**
     * Frame of each figure, counted from its start, at a time in seconds.
     * @param {number} time
     */
    framesAt: (time) => stage?.figures.map((figure3) => figure3.frameAt(time) * figure3.header.step),
    get camera() {
      return stage?.state().camera;
    },
    get playing() {
      return stage?.clock.playing ?? false;
    },
    get speed() {
      return stage?.clock.speed ?? 1;
    },
    get fps() {
      return stage?.frames.fps ?? 0;
    },
    get figures() {
      return stage?.figures.filter((figure3) => figure3.visible).length ?? 0;
    },
    get layout() {
      return stage?.layout;
    },
    get sync() {
      return stage?.timeline.warped ? "warp" : "start";
    },
    get status() {
      return stage?.status ?? "absent";
    }
  };
  whenParsed(() => {
    mount();
    new MutationObserver(mount).observe(document.body, { childList: true, subtree: true });
  });
  register("stage", {
    /** @param {StageRequest} request */
    show(request5) {
      if (request5) player.show(request5);
      return null;
    }
  });

  // shell/address.mjs
  var pageOf = (pathname) => pathname.replace(/\//g, "") || "library";
  function addressOf(pathname, { dataset: dataset2, selection, view: view4, keys, chosen: chosen3, stage: stage2 }) {
    const ofPage = (keys[pageOf(pathname)] || []).map((key) => [key, view4?.[key]]);
    const onStage4 = chosen3 !== "{}" || view4?.walk || view4?.sentence;
    const pairs = new URLSearchParams();
    for (const [key, value] of [
      ["dataset", dataset2],
      ...ofPage,
      ...Object.entries(selection || {}),
      ...Object.entries(onStage4 ? stage2 : {})
    ]) if (value !== null && value !== void 0 && value !== "") pairs.set(String(key), String(value));
    return `${pathname}?${pairs.toString().replace(/%2C/g, ",").replace(/%3A/g, ":")}`;
  }
  var stageOfLink = ({ time, playing: playing3, speed, layout, camera }, turnedByHand2) => ({
    time: playing3 ? "" : time,
    speed: speed === 1 ? "" : speed,
    layout: layout === "overlay" ? "" : layout,
    camera: turnedByHand2 ? [camera.yaw, camera.pitch, camera.distance, ...camera.pan, camera.follow ? 1 : 0].join(",") : ""
  });
  function stateOfLink({ time, speed, layout, camera }) {
    const state3 = {};
    if (time) Object.assign(state3, { time: Number(time), playing: false });
    if (speed) state3.speed = Number(speed);
    if (layout) state3.layout = layout;
    if (camera) {
      const [yaw, pitch, distance, x, y, z, follow3] = camera.split(",").map(Number);
      state3.camera = { yaw, pitch, distance, pan: [x, y, z], follow: follow3 !== 0 };
    }
    return state3;
  }

  // shell/frame.mjs
  var WIDTH_KEY = "motionscape-stage-width";
  var shown2 = { dataset: null, selection: {}, view: {}, keys: {}, chosen: "{}", stage: {} };
  var turnedByHand = false;
  function writeAddress() {
    if (!shown2.dataset) return clientside.no_update;
    const address3 = addressOf(location.pathname, shown2);
    if (address3 !== location.pathname + location.search) history.replaceState(history.state, "", address3);
    return address3;
  }
  window.addEventListener("stage-state", (event) => {
    shown2.stage = stageOfLink(event.detail, turnedByHand);
    writeAddress();
  });
  for (const kind of ["wheel", "pointerdown", "keydown"]) {
    document.addEventListener(kind, (event) => {
      if (targetOf(event).id === STAGE_CANVAS) turnedByHand = true;
    }, { passive: true, capture: true });
  }
  register("shell", {
    // Everything that names what one sees goes into the address, without a new entry in the history.
    /**
     * @param {string} pathname
     * @param {string | null} dataset
     * @param {Selection | null} selection
     * @param {View | null} view
     * @param {Record<string, string[]>} keys
     */
    address(pathname, dataset2, selection, view4, keys) {
      const chosen3 = JSON.stringify(selection || {});
      if (shown2.dataset && (chosen3 !== shown2.chosen || dataset2 !== shown2.dataset)) {
        shown2.stage = {};
        turnedByHand = false;
      }
      Object.assign(shown2, { dataset: dataset2, selection, view: view4, keys, chosen: chosen3 });
      return writeAddress();
    },
    // What the server changes of the view.
    /** @param {ViewChange & { at?: number } | null} change */
    change(change2) {
      const keys = { ...change2 };
      delete keys.at;
      changeView(keys);
      return clientside.no_update;
    },
    // What a link says of the Stage; it is taken up when the motion has arrived.
    /** @param {Record<string, string> | null} stage */
    restore(stage2) {
      if (!stage2 || !Object.keys(stage2).length) return clientside.no_update;
      shown2.stage = stage2;
      if (stage2.camera) turnedByHand = true;
      player.restore(stateOfLink(stage2));
      return clientside.no_update;
    },
    /** @param {{ dataset: string | null } | null} choice @param {string[] | null} cleared */
    choose(choice2, cleared) {
      if (!choice2) return clientside.no_update;
      if (choice2.dataset !== shown2.dataset) {
        setStore(SELECTION, {});
        changeView(Object.fromEntries((cleared || []).map((key) => [key, ""])));
        setStore(STAGE_REQUEST, { dataset: choice2.dataset, items: [] });
        setStore(DATASET, choice2.dataset);
      }
      return clientside.no_update;
    },
    /** @param {string | null} value @param {string | null} dataset */
    pick(value, dataset2) {
      if (value && value !== dataset2) setStore(DATASET_CHOICE, { dataset: value, at: Date.now() });
      return clientside.no_update;
    },
    // One link is the current page's.
    /** @param {string} pathname */
    current(pathname) {
      for (const link2 of allWithin(document, ".nav-link")) {
        if (link2.id === NAV + pageOf(pathname)) link2.setAttribute("aria-current", "page");
        else link2.removeAttribute("aria-current");
      }
      return clientside.no_update;
    },
    /** @param {number | null} clicks */
    async share(clicks) {
      if (!clicks) return clientside.no_update;
      const done = await copy(location.href);
      return [{
        action: "show",
        title: done ? "Link copied" : "Could not copy the link",
        message: done ? "It opens this very view." : "Copy it from the address line.",
        color: done ? "accent" : "orange"
      }];
    }
  });
  async function copy(text) {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      const field = document.createElement("textarea");
      field.value = text;
      field.style.position = "fixed";
      field.style.opacity = "0";
      document.body.append(field);
      field.select();
      const done = document.execCommand("copy");
      field.remove();
      return done;
    }
  }
  document.addEventListener("click", async (event) => {
    const button5 = closest(event, "[data-copy]");
    if (!button5) return;
    const done = await copy(button5.dataset.copy ?? "");
    if (done) notify("Copied", "Paste it where you want to run it.", "accent");
    else notify("Could not copy", button5.dataset.copy ?? "");
  });
  function watchTheme() {
    const root = document.documentElement;
    let last3 = "light";
    const ready2 = () => "set_props" in clientside && Boolean(find(SHELL));
    const tell5 = () => {
      const scheme = root.dataset.mantineColorScheme;
      if (scheme !== "dark" && scheme !== "light" || scheme === last3 || !ready2()) return;
      last3 = scheme;
      setStore(THEME, scheme);
    };
    new MutationObserver(tell5).observe(root, { attributes: true, attributeFilter: ["data-mantine-color-scheme"] });
    const again = setInterval(() => {
      if (!ready2()) return;
      clearInterval(again);
      tell5();
    }, 100);
  }
  function setStageWidth(pixels2) {
    const width = Math.round(Math.min(Math.max(pixels2, 320), innerWidth - 84 - 367));
    document.documentElement.style.setProperty("--stage-width", width + "px");
    document.querySelector(".splitter")?.setAttribute("aria-valuenow", String(Math.round(100 * width / innerWidth)));
    return width;
  }
  function remember(width) {
    try {
      localStorage.setItem(WIDTH_KEY, String(width));
    } catch {
    }
  }
  function watchSplitter() {
    let dragging = null;
    const width = () => within(document, ".stage-panel").getBoundingClientRect().width;
    document.addEventListener("pointerdown", (event) => {
      if (!hasClass(event, "splitter")) return;
      dragging = targetOf(event);
      dragging.classList.add("dragging");
      dragging.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    document.addEventListener("pointermove", (event) => {
      if (dragging) setStageWidth(innerWidth - event.clientX - 3);
    });
    document.addEventListener("pointerup", () => {
      if (!dragging) return;
      dragging.classList.remove("dragging");
      dragging = null;
      remember(width());
    });
    document.addEventListener("keydown", (event) => {
      if (!hasClass(event, "splitter")) return;
      const step3 = { ArrowLeft: 32, ArrowRight: -32 }[event.key];
      if (!step3) return;
      event.preventDefault();
      event.stopPropagation();
      remember(setStageWidth(width() + step3));
    });
    let stored = 0;
    try {
      stored = Number(localStorage.getItem(WIDTH_KEY));
    } catch {
    }
    if (stored > 0) setStageWidth(stored);
  }
  function start() {
    watchTheme();
    watchSplitter();
  }
  whenParsed(start);

  // shared/dialogs.mjs
  function button(name, act2, className = "") {
    const node = element("button", `boards-button ${className}`.trim(), name);
    node.type = "button";
    node.addEventListener("click", act2);
    return node;
  }
  function iconButton(symbol, name, act2) {
    const node = button("", act2, "boards-icon");
    node.append(icon(symbol, 16));
    node.title = name;
    node.setAttribute("aria-label", name);
    return node;
  }
  function openWindow(title, ...parts2) {
    const dialog2 = element("dialog", "boards-dialog", element("h2", "", title), ...parts2);
    dialog2.setAttribute("aria-label", title);
    dialog2.addEventListener("close", () => dialog2.remove());
    dialog2.addEventListener("click", (event) => {
      if (targetOf(event) === /** @type {unknown} */
      dialog2) dialog2.close();
    });
    document.body.append(dialog2);
    dialog2.showModal();
    return dialog2;
  }
  function openForm(title, fields, action, save2) {
    const problem2 = element("p", "form-problem");
    problem2.setAttribute("role", "alert");
    const form2 = element("form", "boards-form", ...fields.map(fieldOf), problem2);
    const send4 = element("button", "boards-button primary", action);
    const dialog2 = openWindow(title, form2);
    form2.append(element("div", "boards-actions", button("Cancel", () => dialog2.close()), send4));
    form2.addEventListener("submit", async (event) => {
      event.preventDefault();
      send4.disabled = true;
      try {
        await save2(Object.fromEntries([...new FormData(form2)].map(([name, value]) => [name, String(value)])));
        dialog2.close();
      } catch (error) {
        problem2.textContent = error instanceof Error ? error.message : String(error);
      }
      send4.disabled = false;
    });
    form2.querySelector("input, textarea, select")?.focus();
    return dialog2;
  }
  function fieldOf({ name, label, value = "", kind = "line", choices: choices2 = [], hint = "" }) {
    let control;
    if (kind === "choice") {
      control = element("select", "", ...choices2.map(([key, words4]) => withAttributes(element("option", "", words4), { value: key })));
    } else control = kind === "text" ? withAttributes(element("textarea"), { rows: 7 }) : element("input");
    control.name = name;
    control.value = value;
    return element("label", "boards-field", element("span", "", label), control, hint && element("small", "muted", hint));
  }
  function openMenu(anchor, entries) {
    const menu = element("div", "boards-menu", ...entries.map(([name, act2]) => {
      const entry = button(name, () => {
        close();
        act2();
      });
      entry.setAttribute("role", "menuitem");
      return entry;
    }));
    menu.setAttribute("role", "menu");
    const { left, right, bottom } = anchor.getBoundingClientRect();
    const stop = new AbortController();
    const close = () => {
      stop.abort();
      menu.remove();
    };
    (document.fullscreenElement ?? document.body).append(menu);
    menu.style.top = `${Math.min(bottom + 4, innerHeight - menu.offsetHeight - 8)}px`;
    menu.style.left = `${Math.max(8, Math.min(left, right - menu.offsetWidth, innerWidth - menu.offsetWidth - 8))}px`;
    const leave3 = (event) => {
      if (!menu.contains(
        /** @type {Node} */
        event.target
      )) close();
    };
    document.addEventListener("pointerdown", leave3, { signal: stop.signal, capture: true });
    menu.addEventListener("keydown", (event) => {
      const at3 = [...menu.children].indexOf(
        /** @type {Element} */
        document.activeElement
      );
      const step3 = { ArrowDown: 1, ArrowUp: -1 }[event.key];
      if (event.key === "Escape") close();
      else if (step3) menu.children[(at3 + step3 + entries.length) % entries.length].focus();
    });
    menu.firstElementChild.focus();
  }
  var line2 = null;
  function say(words4, undo) {
    line2?.remove();
    const shown9 = element("div", "boards-toast", element("span", "", words4), undo ? button("Undo", () => {
      shown9.remove();
      undo();
    }) : null);
    shown9.setAttribute("role", "status");
    line2 = shown9;
    (document.querySelector("dialog[open]") ?? document.fullscreenElement ?? document.body).append(shown9);
    setTimeout(() => shown9.remove(), undo ? 12e3 : 4e3);
  }
  function ago(moment) {
    const minutes = Math.max(0, (Date.now() / 1e3 - moment) / 60);
    if (minutes < 1) return "just now";
    if (minutes < 60) return `${Math.floor(minutes)} min ago`;
    return minutes < 1440 ? `${Math.floor(minutes / 60)} h ago` : new Date(moment * 1e3).toLocaleDateString("en-CA");
  }

  // shell/keys.mjs
  var KEYS2 = [
    ["Everywhere", [["Ctrl K", "go to a page, a clip, a motif, a setting, a board"], ["?", "these keys"], ["Ctrl Z", "undo the last change"], ["Tab", "to the next control"], ["Esc", "close a window"]]],
    ["Tables", [["↑ ↓", "from row to row"], ["Enter", "play the row, or open its link"], ["Space", "choose the row"]]],
    ["Motif graph", [["arrows", "move"], ["+ −", "closer, further away"], ["0", "show all"]]]
  ];
  var writing = (event) => closest(event, "input:not([type=checkbox], [type=radio], [type=range]), textarea, select, [contenteditable=true]") !== null;
  var section = (title, entries) => element("section", "", element("h3", "", title), element("dl", "keys-list", ...entries));
  function showKeys() {
    const stage2 = allWithin(document, ".ms-help dt, .ms-help dd").map((node) => (
      /** @type {Element} */
      node.cloneNode(true)
    ));
    openWindow("Keyboard shortcuts", element(
      "div",
      "keys",
      ...KEYS2.map(([title, keys]) => section(title, keys.flatMap(([key, what]) => [element("dt", "", key), element("dd", "", what)]))),
      section("Stage, when it has the focus", stage2)
    ));
  }
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.altKey || writing(event) || document.querySelector("dialog[open]")) return;
    const control = event.ctrlKey || event.metaKey;
    if (event.key === "?" && !control) showKeys();
    else if (event.key.toLowerCase() === "z" && control && !event.shiftKey && lastUndo()) lastUndo()?.click();
    else return;
    event.preventDefault();
  });
  function lastUndo() {
    const buttons = allWithin(document, '[data-store="undo"], .boards-toast button').filter((button5) => button5.getClientRects().length && button5.textContent === "Undo");
    return buttons.at(-1);
  }

  // shell/menus.mjs
  var SAID = ["aria-haspopup", "aria-expanded", "aria-controls"];
  function hand(box4) {
    const button5 = box4.querySelector("button");
    if (box4.tagName !== "DIV" || box4.hasAttribute("role") || !button5) return;
    for (const name of SAID) {
      const value = box4.getAttribute(name);
      if (value === null) continue;
      button5.setAttribute(name, value);
      box4.removeAttribute(name);
    }
  }
  new MutationObserver((changes) => {
    for (const { type, target: target2, addedNodes } of changes) {
      if (type === "attributes") hand(
        /** @type {Element} */
        target2
      );
      for (const node of addedNodes) {
        if (!(node instanceof Element)) continue;
        if (node.hasAttribute("aria-haspopup")) hand(node);
        for (const box4 of node.querySelectorAll("div[aria-haspopup]")) hand(box4);
      }
    }
  }).observe(document.documentElement, { subtree: true, childList: true, attributeFilter: ["aria-haspopup", "aria-expanded"] });

  // shared/places.mjs
  var sources = [() => allWithin(document, ".nav-link").map((link2) => ({ name: link2.textContent ?? "", about: "page", address: link2.getAttribute("href") ?? "/" }))];
  var addPlaces = (find2) => {
    sources.push(find2);
  };
  async function findPlaces(text) {
    const found = await Promise.all(sources.map(async (find2) => {
      try {
        return await find2(text);
      } catch {
        return [];
      }
    }));
    return matching(found.flat(), text);
  }
  function matching(places, text) {
    const words4 = text.toLowerCase().split(/\s+/).filter(Boolean);
    const found = places.filter(({ name, about }) => words4.every((word) => `${name} ${about}`.toLowerCase().includes(word)));
    const wanted2 = words4.join(" ");
    const distance = ({ name }) => {
      const called = name.toLowerCase();
      return [called === wanted2, called.startsWith(wanted2), called.startsWith(words4[0] ?? ""), true].indexOf(true);
    };
    return found.sort((a, b) => distance(a) - distance(b));
  }

  // shared/server.mjs
  var NAME = "motionscape-name";
  var Refused = class extends Error {
    /** @param {number} status @param {any} answer */
    constructor(status2, answer2) {
      super(answer2?.error || `The server answered with an error (${status2}).`);
      this.status = status2;
      this.answer = answer2 ?? {};
    }
  };
  var person = {
    get name() {
      return localStorage.getItem(NAME) ?? "";
    },
    set name(name) {
      localStorage.setItem(NAME, name.trim().slice(0, 80));
    }
  };
  async function ask2(path2, body2, mark3 = "") {
    const options = body2 ? { method: "POST", headers: { "Content-Type": "application/json", "X-Motionscape": "boards" }, body: JSON.stringify({ author: person.name, ...body2 }) } : { headers: mark3 ? { "If-None-Match": mark3 } : {}, cache: mark3 ? "no-store" : "no-cache" };
    const answer2 = await fetch(`/api/${path2}`, options).catch(() => {
      throw new Error("The server cannot be reached. Is Motionscape still running?");
    });
    if (answer2.status === 304) return null;
    const content = await answer2.json().catch(() => null);
    if (!answer2.ok) throw new Refused(answer2.status, content);
    if (content && !body2 && answer2.headers.get("ETag")) content.etag = answer2.headers.get("ETag");
    return content;
  }

  // shell/palette.mjs
  var MOST = 14;
  var PATIENCE2 = 5e3;
  addPlaces(async (text) => {
    const link2 = encodeURIComponent(location.pathname + location.search);
    return (
      /** @type {any} */
      (await ask2(`places?link=${link2}&text=${encodeURIComponent(text)}`)).places
    );
  });
  var command = (name, about, act2) => ({ name, about, address: "", act: act2 });
  addPlaces(() => [
    command("Keyboard shortcuts", "?", showKeys),
    command("Light or dark", "command", () => find(SCHEME_TOGGLE)?.click()),
    command("Copy a link to this view", "command", () => find(SHARE)?.click())
  ]);
  document.addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() !== "k" || !(event.ctrlKey || event.metaKey) || event.shiftKey || event.altKey) return;
    if (document.querySelector("dialog[open]")) return;
    event.preventDefault();
    openPalette();
  });
  function openPalette() {
    const field = withAttributes(element("input"), { type: "search", placeholder: "A page, a clip, a motif, a setting, a board ...", "aria-label": "Go to", autocomplete: "off" });
    const list3 = withAttributes(element("div", "boards-found"), { role: "group", "aria-label": "Found" });
    const dialog2 = openWindow("Go to", element("div", "boards-form", field, list3));
    const go = (place5) => {
      dialog2.close();
      if (place5.act) place5.act();
      else openPage(place5.address);
      if (place5.opens) unfold(place5.opens);
    };
    let asked3 = 0;
    const show6 = async () => {
      const number2 = ++asked3;
      const found = (await findPlaces(field.value)).slice(0, MOST);
      if (number2 !== asked3) return;
      list3.replaceChildren(...found.map((place5) => {
        const entry = element("button", "boards-button", element("span", "ellipsis", place5.name), element("span", "muted ellipsis", place5.about));
        entry.type = "button";
        entry.addEventListener("click", () => go(place5));
        return entry;
      }), found.length ? "" : element("p", "muted", "Nothing is called so."));
    };
    let shown9 = Promise.resolve();
    field.addEventListener("input", () => {
      shown9 = show6();
    });
    dialog2.addEventListener("keydown", (event) => {
      const entries = allWithin(list3, "button");
      const at3 = entries.indexOf(
        /** @type {any} */
        document.activeElement
      );
      if (event.key === "Escape") dialog2.close();
      else if (event.key === "Enter" && at3 < 0) shown9.then(() => allWithin(list3, "button")[0]?.click());
      else if (event.key === "ArrowDown") entries[Math.min(at3 + 1, entries.length - 1)]?.focus();
      else if (event.key === "ArrowUp") (at3 > 0 ? entries[at3 - 1] : field).focus();
      else return;
      event.preventDefault();
    });
    field.focus();
    shown9 = show6();
  }
  function unfold(id, begun = performance.now()) {
    const head3 = find(id)?.querySelector("button[aria-expanded]");
    if (head3) {
      if (head3.getAttribute("aria-expanded") === "false") head3.click();
    } else if (performance.now() - begun < PATIENCE2) requestAnimationFrame(() => unfold(id, begun));
  }

  // stage/ahead.mjs
  var REST = 90;
  var PATIENCE3 = 400;
  var KEPT = 15e3;
  var OTHER = ["motifs", "motif", "motion", "edge", "transition", "action", "segment", "clip", "start", "end", "as", "time", "speed", "layout", "camera"];
  var requests = /* @__PURE__ */ new Map();
  var current = Promise.resolve();
  var timer = 0;
  var turn = 0;
  function address(selection) {
    const pairs = new URLSearchParams(location.search);
    for (const key of OTHER) pairs.delete(key);
    for (const [key, value] of Object.entries(selection)) pairs.set(key, String(value));
    const page2 = location.pathname.split("/").filter(Boolean).pop() || "library";
    return `${need(STAGE).dataset.api || "/api"}/stage/${page2}?${pairs}`;
  }
  function ask3(selection) {
    const where = address(selection);
    if (!requests.has(where)) {
      const answer2 = fetch(where).then((response) => response.ok ? response.json() : null, () => null);
      requests.set(where, answer2);
      answer2.then((request5) => request5 || requests.delete(where));
      setTimeout(() => requests.delete(where), KEPT);
    }
    return requests.get(where);
  }
  var exceptions = [];
  var usable = (selection) => selection && Object.keys(selection).length > 0 && !selection.motifs && find(STAGE) && !exceptions.some((test) => test(selection));
  var ahead = {
    /**
     * Fetch what a selection plays: at once, or when the pointer has rested (`later`) until `leave`.
     * @param {Selection} selection
     * @param {boolean} [later]
     */
    prepare(selection, later3 = false) {
      clearTimeout(timer);
      if (!usable(selection)) return;
      const fetchIt = async () => player.prefetch(await ask3(selection));
      if (later3) timer = setTimeout(fetchIt, REST);
      else fetchIt();
    },
    leave: () => clearTimeout(timer),
    /**
     * Never play a selection for which `test(selection)` is true.
     * @param {(selection: Selection) => boolean} test
     */
    unless: (test) => exceptions.push(test),
    /** @param {Selection} selection */
    play(selection) {
      if (usable(selection)) current = play(selection);
    },
    /** Until what was played last is on the Stage, but not for long: work that can wait leaves the browser free. */
    settled: () => Promise.race([current, new Promise((done) => setTimeout(done, PATIENCE3))])
  };
  async function play(selection) {
    const mine2 = ++turn;
    const before2 = player.requestCount;
    const request5 = await ask3(selection);
    if (!request5 || mine2 !== turn || before2 !== player.requestCount) return;
    await player.show(request5);
    for (let frame = 0; frame < 2; frame++) await new Promise(requestAnimationFrame);
  }
  var target = (event) => closest(event, '[data-store="selection"]');
  document.addEventListener("pointerover", (event) => {
    const button5 = target(event);
    if (button5) ahead.prepare(JSON.parse(button5.dataset.value ?? "{}"), true);
  });
  document.addEventListener("pointerout", (event) => target(event) && ahead.leave());

  // shell/selecting.mjs
  var put = (store, value, stamp) => {
    if (store === SELECTION) ahead.play(value);
    setStore(store, stamp ? { ...value, at: Date.now() } : value);
  };
  document.addEventListener("click", (event) => {
    const button5 = closest(event, "[data-store]");
    if (!button5 || button5.disabled) return;
    put(button5.dataset.store ?? "", JSON.parse(button5.dataset.value ?? "{}"), button5.dataset.stamp);
    if (button5.dataset.page) clientside.set_props(URL2, { pathname: button5.dataset.page, search: "" });
  });
  gridFunctions.chooseRow = (params) => {
    const at3 = params.event && params.event.type === "click" && params.event.target;
    if (at3 && at3.closest && at3.closest(".choice-cell")) return;
    if (params.data && params.data.view) changeView(params.data.view);
    if (params.data && params.data.selection) put(SELECTION, params.data.selection, false);
  };
  gridFunctions.leaveTable = () => false;
  gridFunctions.chooseRowByKey = (params) => {
    if (params.event && params.event.key === "Enter") gridFunctions.chooseRow(params);
  };
  cellRenderers.Filmstrip = (props) => props.value ? reactElement("img", { className: "filmstrip", src: props.value, alt: "", loading: "lazy", decoding: "async", draggable: false }) : null;
  var MARKS = { ok: "check", warning: "warning", error: "error" };
  cellRenderers.Verdict = (props) => props.value ? reactElement(
    "span",
    { className: "verdict verdict-" + props.value, title: props.data && props.data.messages || void 0 },
    reactElement("span", { className: "icon icon-" + MARKS[props.value], style: { width: 14, height: 14 }, "aria-hidden": "true" }),
    props.value === "error" ? "not read" : props.value
  ) : null;
  var KEYS3 = ["clip", "motif", "edge"];
  var same = (a, b) => Boolean(a && b) && KEYS3.some((key) => key in a) && KEYS3.every((key) => String(a[key] ?? "") === String(b[key] ?? ""));
  var chosen = null;
  var among = (own2) => own2?.motif !== void 0 && Boolean(chosen?.motifs?.split("-").includes(String(own2.motif)));
  gridFunctions.isChosen = (params) => same(params.data && params.data.selection, chosen) || among(params.data && params.data.selection);
  register("tables", {
    /** @param {Selection | null} selection @param {unknown} rows @param {string} id */
    async mark(selection, rows2, id) {
      chosen = selection;
      const api = await gridApi(id);
      const box4 = find(id);
      if (!api || !box4) return clientside.no_update;
      api.forEachNode((node) => {
        if (gridFunctions.isChosen(node)) api.ensureNodeVisible(node);
      });
      for (const row7 of allWithin(box4, ".ag-row")) {
        const node = api.getRowNode(row7.getAttribute("row-id"));
        row7.classList.toggle("row-chosen", Boolean(node) && gridFunctions.isChosen(node));
      }
      return clientside.no_update;
    }
  });

  // shared/settings.mjs
  var keysOf = {};
  function setSettingsKeys(keys) {
    keysOf = keys;
  }
  var changeOfSettings = (name, values) => Object.fromEntries((keysOf[name] || []).map((key) => [key, values[key] ?? ""]));

  // shell/settings.mjs
  var inOrder = (text, of2) => of2.names.filter((name) => text.split(",").includes(name));
  register("settings", {
    // Those keys of the view that are settings of the page; its store is called PAGE-settings.
    /** @param {View | null} view @param {View | null} current @param {string} id @param {Record<string, string[]>} keys */
    pick(view4, current3, id, keys) {
      setSettingsKeys(keys);
      const mine2 = keys[id.slice(0, -"-settings".length)] || [];
      const own2 = Object.entries(view4 || {}).filter(([key]) => mine2.includes(key)).sort();
      const next2 = Object.fromEntries(own2);
      return current3 && JSON.stringify(next2) === JSON.stringify(current3) ? clientside.no_update : next2;
    },
    // Chips for a setting that is a list: here and not on the server, whose answer to one click would undo the next.
    /** @param {Record<string, string> | null} view @param {ListSetting} of */
    list(view4, of2) {
      return inOrder((view4 || {})[of2.key] || of2.usual, of2);
    },
    /** @param {string[] | null} chosen @param {Record<string, string> | null} view @param {ListSetting} of */
    listed(chosen3, view4, of2) {
      const wanted2 = inOrder((chosen3 || []).join(","), of2).join(",");
      const there = (view4 || {})[of2.key] || of2.usual;
      if (wanted2 && wanted2 !== there) changeView({ [of2.key]: wanted2 === of2.usual ? "" : wanted2 });
      return clientside.no_update;
    }
  });

  // shell/views.mjs
  var keyOf = (id) => (
    /** @type {ViewKey} */
    id.split("-").pop()
  );
  register("views", {
    // The control was used: the choice goes into the store; the first choice is the default and leaves the address.
    /** @param {string | null} value @param {View | null} view */
    chosen(value, view4) {
      const key = keyOf(clientside.callback_context.inputs_list[0].id);
      const first = allWithin(document, `.view-panel[data-key="${key}"]`)[0];
      const wanted2 = first && first.dataset.value === value ? "" : value;
      if (value && (view4?.[key] || "") !== wanted2) changeView({ [key]: wanted2 });
      return clientside.no_update;
    },
    // The store changed, or the page came: control and panels follow.
    /** @param {View | null} view @param {string} id */
    show(view4, id) {
      const key = keyOf(id);
      const panels = allWithin(document, `.view-panel[data-key="${key}"]`);
      if (!panels.length) return clientside.no_update;
      const wanted2 = view4?.[key];
      const shown9 = panels.find((panel2) => panel2.dataset.value === wanted2) || panels[0];
      for (const panel2 of panels) panel2.classList.toggle("hidden", panel2 !== shown9);
      return shown9.dataset.value;
    }
  });

  // jobs/ids.mjs
  var JOB_LIST = "job-list";
  var JOB_ACTION = (
    /** @type {StoreId<JobAction>} */
    "job-action"
  );

  // jobs/job_bar.mjs
  function button2(action, job, className, ...children) {
    const made = element("button", "job-button " + className, ...children);
    made.type = "button";
    made.dataset.store = JOB_ACTION;
    made.dataset.value = JSON.stringify({ action, job });
    made.dataset.stamp = "yes";
    return made;
  }
  function alive({ id, title }) {
    const spinner = element("span", "spinner");
    spinner.setAttribute("aria-hidden", "true");
    const progress = element("div", "job-progress", element("div", ""));
    progress.setAttribute("role", "progressbar");
    progress.setAttribute("aria-label", `Progress of ${title}`);
    const percent3 = element("span", "job-percent");
    percent3.setAttribute("aria-hidden", "true");
    return element(
      "div",
      "job",
      spinner,
      element("span", "job-title ellipsis", title),
      progress,
      element("span", "job-stage number", element("span", "job-words"), percent3, element("span", "job-expected")),
      element("div", "job-actions", button2("start", id, "job-start for-editors", "Start anyway"), button2("cancel", id, "job-cancel", "Cancel"))
    );
  }
  function update(row7, { stage: stage2, percent: percent3, stopping, held: held2, expected }) {
    const progress = within(row7, ".job-progress"), known4 = percent3 !== null;
    progress.classList.toggle("waiting", !known4);
    childrenOf(progress)[0].style.width = (percent3 || 0) + "%";
    if (known4) progress.setAttribute("aria-valuenow", String(percent3));
    else progress.removeAttribute("aria-valuenow");
    const words4 = within(row7, ".job-words");
    if (words4.textContent !== stage2) words4.textContent = stage2;
    const took2 = row7.querySelector(".job-expected");
    if (took2 && took2.textContent !== (expected || "")) took2.textContent = expected || "";
    row7.classList.toggle("held", Boolean(held2));
    const number2 = row7.querySelector(".job-percent");
    if (number2) number2.textContent = percent3 ? ` ${percent3} %` : "";
    within(row7, ".job-cancel").disabled = stopping;
  }
  function failed({ id, title, error }) {
    const sign = element("span", "job-mark-failed", icon("error", 18));
    const dismiss = button2("dismiss", id, "job-button-plain", icon("close", 16));
    dismiss.setAttribute("aria-label", "Dismiss");
    return element(
      "div",
      "job job-failed",
      sign,
      element("span", "job-title ellipsis", title),
      element("span", "job-message", error),
      element("div", "job-actions", button2("retry", id, "", "Try again"), dismiss)
    );
  }
  register("jobs", {
    /** @param {Job[] | null} jobs */
    show(jobs) {
      const box4 = need(JOB_LIST);
      const wanted2 = (jobs || []).map((job) => (
        /** @type {[string, Job]} */
        [job.error ? `${job.id} failed` : String(job.id), job]
      ));
      const names2 = new Set(wanted2.map(([name]) => name));
      for (const row7 of childrenOf(box4)) if (!names2.has(row7.dataset.job ?? "")) row7.remove();
      wanted2.forEach(([name, job], k) => {
        let row7 = childrenOf(box4)[k];
        if (!row7 || row7.dataset.job !== name) {
          row7 = job.error ? failed(job) : alive(job);
          row7.dataset.job = name;
          box4.insertBefore(row7, box4.children[k] || null);
        }
        if (!job.error) allWithin(document, `[data-job="${name}"]`).forEach((place5) => update(place5, job));
      });
      return clientside.no_update;
    }
  });

  // blocks/selection.mjs
  function motifsIn(selection) {
    const text = selection.motifs ?? selection.edge ?? (selection.motif === void 0 ? "" : String(selection.motif));
    return new Set(text ? text.split("-").map(Number) : []);
  }
  var meets = ([clip, start3, end], [name, from, to]) => clip === name && 2 * (Math.min(end, to) - Math.max(start3, from)) >= Math.min(end - start3, to - from);
  var isMostly = (words4, label) => Boolean(words4?.startsWith(`${label} (`));
  var isIn = (stretch, motion) => motion.some((one) => meets(stretch, one));
  function motionOf(selection, motifs2) {
    const chosen3 = motifsIn(selection);
    const found = motifs2.filter(({ id }) => chosen3.has(id));
    return found.length ? found.flatMap(({ motions: motions2 }) => motions2) : void 0;
  }
  function motifsToLight(selection, motion, motifs2) {
    const chosen3 = motifsIn(selection);
    if (chosen3.size || !motion.length) return chosen3;
    return new Set(motifs2.filter(({ motions: motions2 }) => motions2.some((one) => isIn(one, motion))).map(({ id }) => id));
  }
  function lightBlocks(blocks, selection) {
    const { clip, start: start3, end } = selection;
    let motion = [];
    if (clip !== void 0) motion = [[clip, start3 ?? 0, end ?? Infinity]];
    else {
      for (const { drawn: drawn8, same: same4 } of blocks) {
        const known4 = same4 ? drawn8.motion?.(selection) : void 0;
        if (known4) {
          motion = known4;
          break;
        }
      }
    }
    const stretch = clip === void 0 ? {} : { clip, start: start3, end };
    for (const { drawn: drawn8, same: same4 } of blocks) drawn8.light?.(same4 ? selection : stretch, motion);
  }

  // boards/grid.mjs
  var COLUMNS2 = 12;
  var ROW2 = 64;
  var NARROW = 620;
  var library = null;
  function gridstack() {
    library ??= new Promise((resolve, reject) => {
      document.head.append(withAttributes(element("link"), { rel: "stylesheet", href: "/assets/vendor/gridstack.css" }));
      const script = element("script");
      script.src = "/assets/vendor/gridstack.js";
      script.onload = () => resolve(
        /** @type {any} */
        globalThis.GridStack
      );
      script.onerror = () => {
        library = null;
        reject(new Error("The grid could not be loaded; reload the page."));
      };
      document.head.append(script);
    });
    return library;
  }
  var Grid = class _Grid {
    /**
     * @param {HTMLElement} place
     * @param {boolean} still nothing may be moved
     * @param {(places: Record<string, number[]>) => void} moved
     */
    static async open(place5, still, moved2) {
      const GridStack = await gridstack();
      return new _Grid(GridStack, place5, still, moved2);
    }
    /** @param {any} GridStack @param {HTMLElement} place @param {boolean} still @param {(places: Record<string, number[]>) => void} moved */
    constructor(GridStack, place5, still, moved2) {
      this.quiet = 0;
      this.grid = GridStack.init({
        column: COLUMNS2,
        cellHeight: ROW2,
        margin: 6,
        float: false,
        animate: false,
        staticGrid: still,
        handle: ".board-head",
        columnOpts: { breakpoints: [{ w: NARROW, c: 1 }] },
        resizable: { handles: "e,se,s,sw,w" }
      }, place5);
      this.grid.on("change", () => {
        if (!this.quiet && this.grid.getColumn() === COLUMNS2) moved2(this.places());
      });
    }
    /** @returns {Record<string, number[]>} */
    places() {
      return Object.fromEntries(this.grid.engine.nodes.map(({ el, x, y, w, h }) => [el.dataset.block, [x, y, w, h]]));
    }
    /** @param {() => void} change */
    silently(change2) {
      this.quiet += 1;
      change2();
      this.quiet -= 1;
    }
    /** Several changes, after which the grid is laid out once. @param {() => void} changes */
    together(changes) {
      this.silently(() => {
        this.grid.batchUpdate();
        changes();
        this.grid.batchUpdate(false);
      });
    }
    /** @param {HTMLElement} item @param {BlockData} block */
    add(item, { x, y, w, h }) {
      this.silently(() => this.grid.makeWidget(item, { x, y, w, h, minW: 2, minH: 2 }));
    }
    /** @param {HTMLElement} item */
    remove(item) {
      this.silently(() => this.grid.removeWidget(item));
    }
    /** Put blocks where others have put them. @param {[HTMLElement, BlockData][]} items */
    place(items) {
      if (this.grid.getColumn() !== COLUMNS2 || document.querySelector(".ui-draggable-dragging, .ui-resizable-resizing")) return;
      const now6 = this.places();
      this.together(() => {
        for (const [item, { id, x, y, w, h }] of items) {
          if (JSON.stringify(now6[id]) !== JSON.stringify([x, y, w, h])) this.grid.update(item, { x, y, w, h });
        }
      });
    }
    /**
     * Arrow keys move a block, with shift they resize it.
     * @param {HTMLElement} item
     * @param {KeyboardEvent} event
     */
    key(item, event) {
      const steps2 = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
      const step3 = steps2[event.key];
      const node = this.grid.engine.nodes.find((one) => one.el === item);
      if (!step3 || !node || this.grid.opts.staticGrid) return;
      event.preventDefault();
      const { x, y, w, h } = node;
      if (event.shiftKey) this.grid.update(item, { w: Math.min(Math.max(w + step3[0], 2), COLUMNS2 - x), h: Math.max(h + step3[1], 2) });
      else {
        this.grid.update(item, { x: Math.min(Math.max(x + step3[0], 0), COLUMNS2 - w), y: Math.max(y + step3[1] * (step3[1] > 0 ? h : 1), 0) });
      }
    }
    /** The first free row below all blocks. */
    bottom() {
      return this.grid.engine.getRow();
    }
    close() {
      this.grid.destroy(false);
    }
  };

  // boards/ahead.mjs
  var FRESH = 1e4;
  var asked = /* @__PURE__ */ new Map();
  function take(path2) {
    const answer2 = asked.get(path2);
    asked.delete(path2);
    return answer2 ?? ask2(path2);
  }
  function begin(path2) {
    const answer2 = ask2(path2);
    answer2.catch(() => {
    });
    asked.set(path2, answer2);
    return answer2;
  }
  async function beginBoard(board2) {
    begin("boards");
    gridstack().catch(() => {
    });
    const { blocks } = (
      /** @type {Board} */
      await begin(`boards/${board2}`)
    );
    for (const { id } of blocks) begin(`boards/${board2}/blocks/${id}`);
  }
  var board = new URLSearchParams(location.search).get("board") ?? "";
  if (location.pathname.endsWith("/boards") && /^[\w-]+$/.test(board)) {
    beginBoard(board).catch(() => {
    });
    setTimeout(() => asked.clear(), FRESH);
  }

  // blocks/registry.mjs
  var offered = {};
  var offer = (blocks) => Object.assign(offered, blocks);
  function drawBlock(place5, kind, content, context) {
    place5.classList.add("block", `block-of-${kind}`);
    if (Object.hasOwn(offered, kind)) return offered[kind](place5, content, context);
    place5.append(element("p", "muted", `This version cannot show a block of the kind “${kind}”.`));
    return {};
  }

  // shared/words.mjs
  function clock(seconds) {
    const tenths = Math.round(seconds * 10);
    return `${Math.floor(tenths / 600)}:${(tenths % 600 / 10).toFixed(1).padStart(4, "0")}`;
  }
  var plural = (n, one, more2 = `${one}s`) => `${n} ${n === 1 ? one : more2}`;
  var percent = (share2) => `${Math.round(100 * share2)} %`;

  // boards/state.mjs
  var shown3 = {
    /** @type {Record<string, string>} */
    view: {},
    dataset: "",
    /** @type {Selection} */
    selection: {}
  };
  var known = { listing: null };
  var kindOf = (kind) => known.listing?.kinds.find((one) => one.kind === kind);
  var isDark = () => document.documentElement.dataset.mantineColorScheme === "dark";

  // boards/card.mjs
  var POLL = 1500;
  var Card = class {
    /**
     * @param {string} board
     * @param {BlockData} block
     * @param {boolean} still
     * @param {Context} context
     * @param {CardActions} actions
     */
    constructor(board2, block2, still, context, actions4) {
      this.board = board2;
      this.still = still;
      this.last = "";
      this.block = block2;
      this.context = context;
      this.actions = actions4;
      this.drawn = {};
      this.mark = "";
      this.waiting = 0;
      this.title = element("h3", "board-title ellipsis");
      this.badge = iconButton("note", "Comments", () => actions4.comment(this));
      this.note = element("div", "board-note");
      this.body = element("div", "board-body");
      const more2 = iconButton("dots", "More", () => actions4.menu(this, more2));
      this.head = element("header", "board-head", this.title, this.badge, still ? null : more2);
      this.head.tabIndex = still ? -1 : 0;
      this.item = element("div", "grid-stack-item", element("section", "grid-stack-item-content board-block", this.head, this.note, this.body));
      this.item.dataset.block = block2.id;
      this.item.dataset.kind = block2.kind;
      this.body.append(element("div", "muted board-empty", "Loading …"));
      this.show(block2);
    }
    /** Whether numbers of motifs and actions mean the same in it as in the selection: the page has its settings. */
    get isSame() {
      const view4 = this.block.settings.view ?? {};
      return (kindOf(this.block.kind)?.keys ?? []).every((key) => (view4[key] ?? "") === (shown3.view[key] ?? ""));
    }
    /** What it is called: its title, or what its kind is called. */
    get name() {
      return this.block.settings.title || kindOf(this.block.kind)?.label || this.block.kind;
    }
    /** Take over a block as it is now; its content is asked for again where that may be another. @param {BlockData} block */
    show(block2) {
      const mark3 = JSON.stringify([block2.kind, block2.settings, block2.data, block2.dataset]);
      this.block = block2;
      this.title.textContent = block2.settings.title ?? "";
      this.head.classList.toggle("board-head-bare", !block2.settings.title);
      this.head.setAttribute("aria-label", `${this.name}. Arrow keys move it, with shift they resize it.`);
      if (mark3 === this.mark) return;
      this.mark = mark3;
      this.load();
    }
    /** @param {number} open @param {number} all */
    count(open6, all) {
      this.badge.dataset.count = open6 ? String(open6) : "";
      this.badge.classList.toggle("board-quiet", !all);
    }
    async load() {
      clearTimeout(this.waiting);
      const mark3 = this.mark;
      let answer2;
      try {
        answer2 = await take(`boards/${this.board}/blocks/${this.block.id}`);
      } catch (error) {
        answer2 = { state: "broken", content: null, words: error instanceof Error ? error.message : String(error), job: null };
      }
      if (mark3 !== this.mark) return;
      this.fill(answer2);
    }
    /** @param {BlockAnswer} answer */
    fill(answer2) {
      const { state: state3, content, words: words4, job } = answer2;
      this.item.dataset.state = state3;
      this.note.replaceChildren();
      const computes = state3 === "missing" && !job && !this.still && kindOf(this.block.kind)?.computes;
      if (content === null) this.clear(element("div", "muted board-empty", words4, computes ? button("Compute", () => this.compute()) : null));
      else if (JSON.stringify(content) !== this.last) this.draw(content);
      if (state3 === "changed") this.note.append(words4, this.still ? "" : button("Recompute", () => this.actions.renew(this)));
      else if (state3 === "gone") this.note.append(words4);
      else if (computes && content !== null) this.note.append(words4, button("Compute", () => this.compute()));
      if (job?.state === "failed") this.note.append(job.error);
      else if (job) {
        this.note.append(`Computing: ${percent(job.fraction)}`);
        this.waiting = window.setTimeout(() => this.load(), POLL);
      }
    }
    async compute() {
      await ask2(`boards/${this.board}/blocks/${this.block.id}/compute`, {}).catch((error) => this.note.replaceChildren(error.message));
      await this.load();
    }
    /** @param {any} content */
    draw(content) {
      this.clear();
      this.last = JSON.stringify(content);
      const place5 = element("div", "board-content");
      this.body.append(place5);
      this.drawn = drawBlock(place5, this.block.kind, content, this.context);
      this.actions.drawn(this);
    }
    /** @param {...Node} parts */
    clear(...parts2) {
      this.drawn.close?.();
      this.drawn = {};
      this.last = "";
      this.body.replaceChildren(...parts2);
    }
    close() {
      clearTimeout(this.waiting);
      this.drawn.close?.();
      this.mark = "closed";
    }
  };

  // boards/comments.mjs
  function countOf(comments, block2) {
    const own2 = comments.filter((comment) => comment.block === block2 && !comment.parent);
    return [own2.filter((comment) => !comment.resolved).length, own2.length];
  }
  var Comments = class {
    /** @param {() => Promise<unknown>} again asks for the board anew */
    constructor(again) {
      this.again = again;
      this.node = element("aside", "boards-comments");
      this.node.setAttribute("aria-label", "Comments");
      this.node.hidden = true;
      this.node.addEventListener("keydown", (event) => event.key === "Escape" && this.close());
      this.block = "";
      this.title = "";
      this.last = "";
      this.board = null;
    }
    /** @param {Board} board @param {string} block @param {string} title */
    open(board2, block2, title) {
      Object.assign(this, { block: block2, title });
      this.node.hidden = false;
      this.last = "";
      this.show(board2);
      this.node.querySelector("textarea")?.focus();
    }
    close() {
      this.node.hidden = true;
    }
    /** Draw what has been said, unless nothing has changed or someone is writing an answer. @param {Board} board */
    show(board2) {
      this.board = board2;
      const own2 = board2.comments.filter((comment) => comment.block === this.block);
      const mark3 = JSON.stringify(own2);
      if (this.node.hidden || mark3 === this.last) return;
      const draft = this.node.querySelector("textarea")?.value ?? "";
      this.last = mark3;
      const threads = own2.filter((comment) => !comment.parent).sort((a, b) => Number(a.resolved) - Number(b.resolved) || b.created - a.created);
      this.node.replaceChildren(
        element("div", "boards-bar", element("h3", "ellipsis", this.title), iconButton("close", "Close the comments", () => this.close())),
        this.form("Say something; @name tells someone", "Comment", (text) => this.send({ action: "add", text, place: this.place() }), draft),
        ...threads.map((comment) => this.thread(comment, own2.filter((answer2) => answer2.parent === comment.id))),
        threads.length ? "" : element("p", "muted", "Nobody has said anything yet.")
      );
    }
    place() {
      return this.block ? `board:${this.board?.id}/block:${this.block}` : `board:${this.board?.id}`;
    }
    /** @param {CommentData} comment @param {CommentData[]} answers */
    thread(comment, answers) {
      const act2 = comment.resolved ? "reopen" : "resolve";
      const folded2 = comment.resolved;
      const node = element("article", `boards-comment${folded2 ? " resolved" : ""}`, this.said(comment), ...answers.map((answer2) => this.said(answer2)));
      const actions4 = element(
        "div",
        "boards-comment-actions",
        button(folded2 ? "Reopen" : "Resolve", () => this.send({ action: act2, id: comment.id })),
        folded2 ? null : button("Answer", () => {
          actions4.replaceWith(this.form("Answer", "Answer", (text) => this.send({ action: "add", text, place: this.place(), parent: comment.id })));
          node.querySelector("textarea")?.focus();
        })
      );
      node.append(actions4);
      return node;
    }
    /** @param {CommentData} comment */
    said({ author, created, text, resolved }) {
      const words4 = text.split(/(@[\w][\w.-]*)/).map((part2) => part2.startsWith("@") ? element("mark", "boards-mention", part2) : part2);
      return element("div", "boards-said", element("div", "muted", `${author || "Someone"}, ${ago(created)}${resolved ? ", resolved" : ""}`), element("p", "", ...words4));
    }
    /** @param {string} hint @param {string} action @param {(text: string) => Promise<void>} send @param {string} [draft] */
    form(hint, action, send4, draft = "") {
      const text = withAttributes(element("textarea"), { rows: 2, placeholder: hint, "aria-label": hint });
      text.value = draft;
      const names2 = element("div", "boards-names");
      text.addEventListener("input", () => this.offer(text, names2));
      const problem2 = element("p", "form-problem");
      const form2 = element("form", "boards-form", text, names2, problem2, element("button", "boards-button primary", action));
      form2.addEventListener("submit", async (event) => {
        event.preventDefault();
        const said2 = text.value;
        text.value = "";
        await send4(said2).catch((error) => {
          text.value = said2;
          problem2.textContent = error.message;
        });
      });
      return form2;
    }
    /** Names to mention, while one types after an @. @param {HTMLTextAreaElement} text @param {HTMLElement} names */
    offer(text, names2) {
      const begun = /@([\w.-]*)$/.exec(text.value.slice(0, text.selectionStart));
      const known4 = begun ? (this.board?.names ?? []).filter((name) => name.toLowerCase().startsWith(begun[1].toLowerCase())).slice(0, 5) : [];
      names2.replaceChildren(...known4.map((name) => button(`@${name}`, () => {
        const at3 = text.selectionStart;
        text.setRangeText(`@${name.replace(/\s+/g, ".")} `, at3 - (begun?.[0].length ?? 0), at3, "end");
        names2.replaceChildren();
        text.focus();
      })));
    }
    /** @param {Record<string, any>} body */
    async send(body2) {
      if (body2.action === "add" && !this.board?.me && !person.name) person.name = window.prompt("Your name, for the others:") ?? "";
      await ask2("comments", body2);
      await this.again();
    }
  };
  var wordsOf = (comments) => {
    const open6 = comments.filter((comment) => !comment.resolved && !comment.parent).length;
    return open6 ? plural(open6, "open comment") : "Comments";
  };

  // boards/edit.mjs
  var viewOf = (kind) => Object.fromEntries(Object.entries(shown3.view).filter(([key, text]) => text && kind?.keys.includes(key)));
  function addBlock(board2, row7, take4) {
    const kinds2 = known.listing?.kinds ?? [];
    const dialog2 = openWindow("Add a block", element("div", "boards-kinds", ...kinds2.map((kind) => button(kind.label, () => {
      dialog2.close();
      fillIn(board2, kind, row7, take4);
    }))), element("p", "muted", "A block takes over the settings of the page as they are now; a Stage loop plays what is selected."));
  }
  function fillIn(board2, kind, row7, take4) {
    const settings = { title: kind.kind === "text" || kind.kind === "numbers" ? "" : kind.label, view: viewOf(kind), options: {} };
    if (kind.kind === "stage") settings.options = { selection: JSON.stringify(shown3.selection) };
    const [w, h] = kind.size;
    const add3 = async (filled2) => take4(await ask2(`boards/${board2.id}`, { action: "add", block: { kind: kind.kind, x: 0, y: row7, w, h, settings: filled2 } }));
    if (!["text", "view"].includes(kind.kind)) return add3(settings);
    return openForm(`Add: ${kind.label}`, fieldsOf(board2, kind.kind, settings), "Add", (values) => add3(settingsOf(settings, values)));
  }
  function editBlock(board2, block2, take4) {
    openForm("Change the block", fieldsOf(board2, block2.kind, block2.settings), "Save", async (values) => {
      const settings = settingsOf(block2.settings, values);
      try {
        take4(await saveBlock(board2, block2, settings));
      } catch (error) {
        if (!(error instanceof Refused) || !error.answer.conflict) throw error;
        tellConflict(board2, block2, settings, error.answer, take4);
      }
    });
  }
  var saveBlock = (board2, { id, kind, version: own2 }, settings, version = own2) => ask2(`boards/${board2.id}`, { action: "change", version, block: { id, kind, settings } });
  function tellConflict(board2, block2, mine2, { error, theirs, author }, take4) {
    const column = (title, text, choice2) => element("div", "boards-version", element("h3", "", title), element("pre", "", text), choice2);
    const dialog2 = openWindow("Someone was faster", element("p", "", error), element(
      "div",
      "boards-versions",
      column("Yours", wordsOf2(mine2), theirs ? button("Save mine over it", async () => {
        take4(await saveBlock(board2, block2, mine2, theirs.version));
        dialog2.close();
      }, "primary") : button("Add mine again", async () => {
        take4(await ask2(`boards/${board2.id}`, { action: "add", block: { ...block2, settings: mine2 } }));
        dialog2.close();
      }, "primary")),
      column(theirs ? `Of ${author || "someone else"}` : "Removed", theirs ? wordsOf2(theirs.settings) : "The block is no longer on the board.", button("Keep theirs", () => dialog2.close()))
    ));
    dialog2.classList.add("boards-conflict");
  }
  var wordsOf2 = ({ title, note, dataset: dataset2, view: view4, options }) => [
    ["Title", title],
    ["Note", note],
    ["Dataset", dataset2],
    ...Object.entries(view4 ?? {}),
    ...Object.entries(options ?? {})
  ].filter(([, value]) => value).map(([name, value]) => `${name}: ${value}`).join("\n");
  function fieldsOf(board2, kind, { title = "", dataset: dataset2 = "", view: view4 = {}, options = {} }) {
    const fields = [{ name: "title", label: "Title", value: title }];
    if (kind === "text") return [...fields, { name: "option-markdown", label: "Text", kind: "text", value: options.markdown ?? "", hint: "Markdown: ## heading, **bold**, - list, [words](address)" }];
    if (kind === "view") {
      return [...fields, { name: "option-view", label: "Saved view", kind: "choice", value: options.view ?? "", choices: (known.listing?.views ?? []).map(({ id, title: name }) => [id, name]) }];
    }
    fields.push({ name: "dataset", label: "Dataset", kind: "choice", value: dataset2, choices: [["", "that of the board"], ...board2.datasets.map((name) => (
      /** @type {[string, string]} */
      [name, name]
    ))] });
    if (kindOf(kind)?.keys.length) fields.push({ name: "view", label: "Settings", value: Object.entries(view4).map(([key, text]) => `${key}=${text}`).join("; "), hint: `As in links, such as kappa=200; gamma=2. Known: ${kindOf(kind)?.keys.join(", ")}` });
    for (const [name, hint] of Object.entries(kindOf(kind)?.options ?? {})) {
      if (kind === "stage") fields.push({ name: `option-${name}`, label: "What plays", kind: "choice", value: options[name] ?? "", choices: playable(options[name]) });
      else fields.push({ name: `option-${name}`, label: name[0].toUpperCase() + name.slice(1), value: options[name] ?? "", hint });
    }
    return fields;
  }
  function playable(own2) {
    const now6 = JSON.stringify(shown3.selection);
    const choices2 = own2 ? [[own2, `as it is: ${own2}`]] : [];
    return now6 === "{}" || now6 === own2 ? choices2 : [...choices2, [now6, `what is selected now: ${now6}`]];
  }
  function settingsOf(before2, values) {
    const options = Object.entries(values).filter(([name]) => name.startsWith("option-")).map(([name, value]) => [name.slice(7), value]);
    const settings = { ...before2, title: values.title ?? before2.title ?? "", options: { ...before2.options, ...Object.fromEntries(options) } };
    if (values.dataset !== void 0) settings.dataset = values.dataset;
    if (values.view !== void 0) settings.view = Object.fromEntries(values.view.split(";").map((pair) => pair.split("=").map((part2) => part2.trim())).filter(([key, text]) => key && text));
    delete settings.pinned;
    return settings;
  }

  // boards/picture.mjs
  var [WIDTH, HEIGHT, BESIDE] = [360, 220, 130];
  var SETTLED = 3e3;
  function renewPicture(id, address3) {
    window.setTimeout(async () => {
      if (location.pathname !== new URL(address3, location.href).pathname || document.visibilityState !== "visible") return;
      const picture2 = await pictureOfPage().catch(() => "");
      if (picture2) await ask2(`views/${id}`, { action: "picture", picture: picture2 }).catch(() => void 0);
    }, SETTLED);
  }
  async function pictureOfPage() {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [WIDTH, HEIGHT];
    const context = context2d(canvas);
    context.fillStyle = getComputedStyle(document.body).backgroundColor;
    context.fillRect(0, 0, WIDTH, HEIGHT);
    const page2 = find(PAGE);
    const main = page2 ? largest(page2) : null;
    const stage2 = (
      /** @type {HTMLCanvasElement | null} */
      /** @type {unknown} */
      find(STAGE_CANVAS)
    );
    const beside = main ? BESIDE : WIDTH;
    const width = stage2 ? WIDTH - beside : WIDTH;
    if (main) {
      const box4 = main.getBoundingClientRect();
      const scale3 = Math.min(width / box4.width, HEIGHT / box4.height);
      for (const part2 of allWithin(main, "canvas, svg")) await draw(context, part2, box4, scale3, (width - box4.width * scale3) / 2, (HEIGHT - box4.height * scale3) / 2);
    }
    if (stage2?.width) {
      const scale3 = Math.max(beside / stage2.width, HEIGHT / stage2.height);
      const [wide, high] = [beside / scale3, HEIGHT / scale3];
      context.drawImage(stage2, (stage2.width - wide) / 2, (stage2.height - high) / 2, wide, high, WIDTH - beside, 0, beside, HEIGHT);
    }
    return canvas.toDataURL("image/jpeg", 0.72);
  }
  function largest(page2) {
    const area = (node) => {
      const { width, height } = node.getBoundingClientRect();
      return width * height;
    };
    const drawings2 = allWithin(page2, "canvas, svg").sort((a, b) => area(b) - area(a));
    return drawings2.length && area(drawings2[0]) > 1e4 ? drawings2[0].parentElement : null;
  }
  async function draw(context, part2, frame, scale3, left, top) {
    const box4 = part2.getBoundingClientRect();
    if (!box4.width || !box4.height) return;
    let image;
    if (part2 instanceof HTMLCanvasElement) {
      if (!part2.width || !part2.height) return;
      image = part2;
    } else {
      const copy2 = (
        /** @type {Element} */
        part2.cloneNode(true)
      );
      copy2.setAttribute("width", String(box4.width));
      copy2.setAttribute("height", String(box4.height));
      const text = new XMLSerializer().serializeToString(copy2);
      image = new Image();
      image.src = `data:image/svg+xml;utf8,${encodeURIComponent(text)}`;
      await image.decode();
    }
    context.drawImage(image, left + (box4.left - frame.left) * scale3, top + (box4.top - frame.top) * scale3, box4.width * scale3, box4.height * scale3);
  }

  // boards/reports.mjs
  var POLL2 = 500;
  function openReport(dataset2, board2) {
    const place5 = element("div", "boards-form");
    const dialog2 = openWindow(board2 ? `Report of ${board2.title}` : `Report of ${dataset2}`, element(
      "p",
      "muted",
      "One file that opens without Motionscape and without a network. Its figures play, its graph and map can be explored."
    ), place5);
    const begin3 = (form2) => write(dialog2, place5, dataset2, board2?.id ?? "", form2);
    place5.append(element("div", "boards-actions", button("As PDF", () => begin3("pdf")), button("As HTML", () => begin3("html"), "primary")));
  }
  document.addEventListener("click", (event) => {
    const { report } = closest(event, "[data-report]")?.dataset ?? {};
    if (report) openReport(report, null);
  });
  async function write(dialog2, place5, dataset2, board2, form2) {
    const address3 = `report/${encodeURIComponent(dataset2)}`;
    let again = "&again=yes";
    while (dialog2.open) {
      const state3 = await ask2(`${address3}?form=${form2}&board=${board2}${again}`).catch((error) => ({ error: error.message }));
      again = "";
      if (state3.error) {
        place5.replaceChildren(element("p", "form-problem", state3.error), element("div", "boards-actions", button("Close", () => dialog2.close())));
        return;
      }
      if (state3.ready) {
        const link2 = element("a", "boards-button primary", `Save ${(state3.size / 1e6).toFixed(1)} MB`);
        link2.href = `/api/${address3}/${state3.key}`;
        link2.download = "";
        place5.replaceChildren(element("p", "", state3.motion), ...state3.left_out.map((words4) => element("p", "muted", `Left out: ${words4}`)), element("div", "boards-actions", link2));
        link2.focus();
        return;
      }
      const bar = element("progress", "boards-progress");
      bar.value = state3.fraction;
      place5.replaceChildren(element("p", "", `Writing: ${state3.words}, ${percent(state3.fraction)}`), bar);
      await new Promise((resolve) => setTimeout(resolve, POLL2));
    }
  }

  // boards/list.mjs
  var COLOURS = { graph: 0, motifs: 0, matrix: 0, map: 1, overview: 2, tracks: 2, actions: 3, sweep: 4, hits: 5, stage: 6 };
  async function refresh() {
    known.listing = await take("boards");
    return (
      /** @type {Listing} */
      known.listing
    );
  }
  async function showList(place5) {
    const listing2 = await refresh();
    const search2 = withAttributes(element("input", "boards-search"), { type: "search", placeholder: "Search boards and views", "aria-label": "Search boards and views" });
    const [boards, views] = [element("div", "boards-cards"), element("div", "boards-cards")];
    const again = async () => {
      await refresh();
      fill();
    };
    const fill = () => {
      const { boards: all, views: saved } = (
        /** @type {Listing} */
        known.listing
      );
      const words4 = search2.value.toLowerCase().split(/\s+/).filter(Boolean);
      const found = (texts) => words4.every((word) => texts.join(" ").toLowerCase().includes(word));
      const [some, more2] = [all.filter((board2) => found([board2.title, board2.note, board2.author, board2.dataset])), saved.filter((one) => found([one.title, one.note, one.author, ...one.tags]))];
      boards.replaceChildren(...some.map((board2) => boardCard(board2, again)), ...some.length ? [] : [all.length ? empty("No board is called so.") : beginning()]);
      views.replaceChildren(...more2.map((one) => viewCard(one, again)), ...more2.length ? [] : [empty(saved.length ? "No view is called so." : "Save a view with “Save view” at the top, on any page.")]);
    };
    search2.addEventListener("input", fill);
    fill();
    const { damaged } = listing2;
    place5.replaceChildren(
      element("div", "boards-bar", element("h2", "", "Boards"), search2, shown3.dataset ? button(`Report of ${shown3.dataset}`, () => openReport(shown3.dataset, null)) : null, button("New board", openGallery, "primary for-editors")),
      ...damaged.length ? [element("p", "boards-warning", `${damaged.length} saved ${damaged.length > 1 ? "things are" : "thing is"} damaged and not listed: ${damaged.join(", ")}.`)] : [],
      boards,
      element("h2", "", "Saved views"),
      views
    );
  }
  var beginning = () => element(
    "section",
    "boards-beginning",
    element("h3", "", "Look at motion together"),
    element("p", "muted", "A board shows graphs, maps, tables and motion side by side. Everyone who has its link open sees what the others change."),
    element("div", "boards-cards for-editors", ...templateCards(() => void 0))
  );
  var empty = (words4) => element("p", "muted", words4);
  function boardCard(board2, again) {
    const open6 = button("", () => changeView({ board: board2.id, screen: "" }), "boards-open");
    open6.append(drawShape(board2.shape), element("strong", "ellipsis", board2.title));
    const about = [board2.dataset, board2.author, ago(board2.updated)].filter(Boolean).join(" · ");
    const more2 = iconButton("dots", `More for ${board2.title}`, () => openMenu(more2, [
      ["Rename", () => renameBoard(board2, again)],
      ["Duplicate", () => change(board2.id, { action: "duplicate" }).then(again)],
      ["History", () => showHistory(`boards/${board2.id}`, board2.title, (version) => change(board2.id, { action: "restore", version }).then(again))],
      ["Delete", () => deleteBoard(board2, again)]
    ]));
    more2.classList.add("for-editors");
    return element("article", "boards-card", open6, element("div", "boards-card-foot", element("span", "muted ellipsis", about), more2));
  }
  var change = (id, body2) => ask2(`boards/${id}`, body2).catch((error) => say(error.message));
  var renameBoard = (board2, again) => openForm("Rename the board", [
    { name: "title", label: "Title", value: board2.title },
    { name: "note", label: "Note", kind: "text", value: board2.note }
  ], "Save", (values) => ask2(`boards/${board2.id}`, { action: "rename", ...values }).then(again));
  async function deleteBoard(board2, again) {
    if (!await change(board2.id, { action: "delete" })) return;
    again();
    say(`“${board2.title}” was deleted.`, () => change(board2.id, { action: "undelete" }).then(again));
  }
  function viewCard(saved, again) {
    const picture2 = withAttributes(element("img", "boards-picture"), { src: saved.picture, alt: "", loading: "lazy" });
    picture2.addEventListener("error", () => picture2.replaceWith(element("div", "boards-picture boards-no-picture", new URL(saved.address, location.href).pathname.slice(1))));
    const open6 = button("", () => {
      followLink(saved.address);
      renewPicture(saved.id, saved.address);
    }, "boards-open");
    open6.append(picture2, element("strong", "ellipsis", saved.title));
    if (saved.note) open6.title = saved.note;
    const about = [saved.author, ago(saved.updated), ...saved.tags.map((tag) => `#${tag}`)].filter(Boolean).join(" · ");
    const act2 = (body2) => ask2(`views/${saved.id}`, body2).then(again, (error) => say(error.message));
    const more2 = iconButton("dots", `More for ${saved.title}`, () => openMenu(more2, [
      ["Edit", () => openForm("Edit the saved view", viewFields(saved), "Save", (values) => ask2("views", { id: saved.id, version: saved.version, address: saved.address, ...values, tags: tagsOf(values.tags) }).then(again))],
      ["Versions", () => showHistory(`views/${saved.id}`, saved.title, (version) => act2({ action: "restore", version }))],
      ["Delete", async () => {
        await act2({ action: "delete" });
        say(`“${saved.title}” was deleted.`, () => act2({ action: "undelete" }));
      }]
    ]));
    more2.classList.add("for-editors");
    return element("article", "boards-card", open6, element("div", "boards-card-foot", element("span", "muted ellipsis", about), more2));
  }
  var viewFields = (saved) => [
    { name: "title", label: "Title", value: saved.title ?? "" },
    { name: "note", label: "Note", kind: "text", value: saved.note ?? "" },
    { name: "tags", label: "Tags", value: (saved.tags ?? []).join(", "), hint: "separated by commas" }
  ];
  var tagsOf = (text) => text.split(",").map((tag) => tag.trim()).filter(Boolean);
  var followLink = (address3) => openPage(address3);
  async function showHistory(path2, title, restore) {
    const { history: history2 } = await ask2(`${path2}/history`);
    const dialog2 = openWindow(`History of ${title}`, element("ol", "boards-history", ...history2.map((entry, k) => element(
      "li",
      "",
      element("span", "", `Version ${entry.version}: ${entry.what}`),
      element("span", "muted", [entry.author, ago(entry.saved)].filter(Boolean).join(", ")),
      k ? button("Restore", () => {
        dialog2.close();
        restore(entry.version);
      }) : element("span", "muted", "present")
    ))));
  }
  function openGallery() {
    const dialog2 = openWindow("New board", element("div", "boards-cards", ...templateCards(() => dialog2.close())));
  }
  function templateCards(chosen3) {
    const { templates } = (
      /** @type {Listing} */
      known.listing
    );
    return templates.map((template) => {
      const card4 = button("", () => {
        chosen3();
        openForm(`New board: ${template.title}`, [{ name: "title", label: "Title", value: template.name === "empty" ? "" : `${shown3.dataset}: ${template.title.toLowerCase()}` }], "Make it", async ({ title }) => {
          const board2 = await ask2("boards", { template: template.name, title, dataset: shown3.dataset });
          changeView({ board: board2.id, screen: "" });
        });
      }, "boards-open boards-card");
      card4.append(drawShape(template.shape), element("strong", "", template.title), element("span", "muted", template.words));
      return card4;
    });
  }
  function drawShape(shape2) {
    const height = Math.max(6, ...shape2.map(([, y, , h]) => y + h));
    const svg = svgElement("svg", { class: "boards-shape", viewBox: `0 0 12 ${height}`, preserveAspectRatio: "none", "aria-hidden": "true" });
    for (const [x, y, w, h, kind] of shape2) {
      svg.append(svgElement("rect", { x: x + 0.1, y: y + 0.15, width: w - 0.2, height: h - 0.3, rx: 0.15, class: `boards-shade-${COLOURS[
        /** @type {keyof typeof COLOURS} */
        kind
      ] ?? 7}` }));
    }
    return svg;
  }

  // boards/board.mjs
  var EVERY = 1e3;
  var SETTLED2 = 350;
  var motions = new MotionCache();
  var OpenBoard = class {
    /** @param {HTMLElement} place @param {string} id @param {string} look "read", "present" or "" */
    constructor(place5, id, look2) {
      this.place = place5;
      this.id = id;
      this.look = look2;
      this.cards = /* @__PURE__ */ new Map();
      this.comments = new Comments(() => this.update(true));
      this.mark = "";
      this.closed = false;
      this.timer = 0;
      this.moving = 0;
      this.lighting = 0;
      this.board = null;
      this.grid = null;
      this.warning = element("p", "boards-warning");
      this.warning.setAttribute("role", "alert");
      this.warning.hidden = true;
      this.note = element("p", "muted boards-note");
      this.stale = element("div", "boards-stale");
      this.bar = element("div", "boards-bar");
      this.barMark = "";
      this.area = void 0;
      this.among = null;
      this.filterMark = "";
    }
    get still() {
      return this.look !== "" || !this.board?.may_edit;
    }
    async open() {
      let board2;
      try {
        const all = [take(`boards/${this.id}`), known.listing ? null : refresh(), gridstack()];
        board2 = /** @type {Board} */
        (await Promise.all(all))[0];
      } catch (error) {
        return this.fail(error);
      }
      this.board = board2;
      this.mark = board2.etag ?? "";
      const area = element("div", "grid-stack boards-grid");
      this.place.replaceChildren(element("div", "boards-open-board", element("div", "boards-main", this.bar, this.note, this.warning, this.stale, area), this.comments.node));
      this.grid = await Grid.open(area, this.still, (places) => this.moved(places));
      if (this.closed) return void 0;
      this.area = area;
      this.show(board2);
      if (board2.filters.dataset && board2.filters.dataset !== shown3.dataset && board2.datasets.includes(board2.filters.dataset)) {
        setStore(DATASET_CHOICE, { dataset: board2.filters.dataset, at: Date.now() });
      }
      this.poll();
      return void 0;
    }
    close() {
      this.closed = true;
      clearTimeout(this.timer);
      cancelAnimationFrame(this.lighting);
      for (const card4 of this.cards.values()) card4.close();
    }
    /** @param {unknown} error */
    fail(error) {
      const words4 = error instanceof Error ? error.message : String(error);
      this.place.replaceChildren(element("div", "empty-state", element("h2", "", "This board cannot be shown"), element("p", "muted", words4), button("All boards", () => changeView({ board: "", screen: "" }))));
    }
    poll() {
      this.timer = window.setTimeout(async () => {
        if (this.closed || !this.place.isConnected) return this.close();
        if (document.visibilityState === "visible") await this.update();
        return this.poll();
      }, EVERY);
    }
    /** Ask whether the board has changed. @param {boolean} [surely] */
    async update(surely) {
      try {
        const board2 = await ask2(`boards/${this.id}`, void 0, surely ? "" : this.mark);
        this.warn("");
        if (board2 && !this.closed) {
          this.mark = board2.etag ?? "";
          this.show(board2);
        }
      } catch (error) {
        if (error instanceof Refused && error.status === 404) this.warn("This board has been deleted, or its link renewed. What you see is its last state.");
        else this.warn(`${error instanceof Error ? error.message : error} Trying again; what you change now is not saved.`);
      }
    }
    /** @param {string} words */
    warn(words4) {
      this.warning.hidden = !words4;
      this.warning.textContent = words4;
    }
    /** @param {Board} board */
    show(board2) {
      if (this.moving && this.board) board2 = { ...board2, blocks: board2.blocks.map((block2) => ({ ...block2, ...placeOf(this.board, block2.id) })) };
      this.board = board2;
      this.showBar(board2);
      this.showFilters(board2);
      this.note.textContent = board2.note;
      const ids = new Set(board2.blocks.map(({ id }) => id));
      this.grid?.together(() => {
        for (const [id, card4] of this.cards) if (!ids.has(id)) this.drop(id, card4);
        for (const block2 of board2.blocks) this.put(block2);
      });
      this.grid?.place(board2.blocks.map((block2) => [
        /** @type {Card} */
        this.cards.get(block2.id).item,
        block2
      ]));
      for (const [id, card4] of this.cards) {
        const [open6, all] = countOf(board2.comments, id);
        card4.count(open6, all);
      }
      this.showStale(board2);
      this.comments.show(board2);
    }
    /** @param {BlockData} block */
    put(block2) {
      const card4 = this.cards.get(block2.id);
      if (card4?.block.kind === block2.kind) return card4.show(block2);
      if (card4) this.drop(block2.id, card4);
      const fresh = new Card(this.id, block2, this.still, this.contextOf(block2), {
        menu: (one, anchor) => this.menu(one, anchor),
        comment: (one) => this.comments.open(
          /** @type {Board} */
          this.board,
          one.block.id,
          one.name
        ),
        renew: (one) => this.change({ action: "renew", block: one.block.id }).then(() => one.compute()),
        drawn: (one) => {
          this.narrowOne(one);
          this.light();
        }
      });
      fresh.head.addEventListener("keydown", (event) => {
        if (event.target === fresh.head) this.grid?.key(fresh.item, event);
      });
      this.cards.set(block2.id, fresh);
      this.area?.append(fresh.item);
      this.grid?.add(fresh.item, block2);
      return void 0;
    }
    /** @param {string} id @param {Card} card */
    drop(id, card4) {
      card4.close();
      this.cards.delete(id);
      this.grid?.remove(card4.item);
    }
    /** What a block may ask of the page. @param {BlockData} block @returns {Context} */
    contextOf(block2) {
      const now6 = () => this.cards.get(block2.id)?.block ?? block2;
      return {
        opens: true,
        dark: isDark,
        select: (selection) => this.select(now6(), selection),
        figures: async (items, request5) => {
          const found = await motions.load("/api", request5 ?? { dataset: now6().dataset, items }, items);
          return found.flatMap((motion, k) => motion instanceof Error ? [] : [new Figure(items[k], motion, k)]);
        }
      };
    }
    /** Select something as the block shows it: with its dataset and its settings. @param {BlockData} block @param {Selection} selection */
    select(block2, selection) {
      if (block2.dataset && block2.dataset !== shown3.dataset) setStore(DATASET_CHOICE, { dataset: block2.dataset, at: Date.now() });
      const keys = kindOf(block2.kind)?.keys ?? [];
      const view4 = block2.settings.view ?? {};
      if (kindOf(block2.kind)?.computes) changeView(Object.fromEntries(keys.map((key) => [key, view4[key] ?? ""])));
      setStore(SELECTION, selection);
    }
    /** Show what is selected in all blocks; several changes at once are shown once. */
    light() {
      this.lighting ||= requestAnimationFrame(() => {
        this.lighting = 0;
        const cards = [...this.cards.values()];
        lightBlocks(cards.filter(({ block: block2 }) => block2.dataset === shown3.dataset).map((card4) => ({ drawn: card4.drawn, same: card4.isSame })), shown3.selection);
        lightBlocks(cards.filter(({ block: block2 }) => block2.dataset !== shown3.dataset).map((card4) => ({ drawn: card4.drawn, same: false })), {});
        for (const { drawn: drawn8 } of cards) drawn8.settle?.(shown3.view);
      });
    }
    recolour() {
      for (const card4 of this.cards.values()) card4.drawn.recolour?.();
    }
    reload() {
      for (const card4 of this.cards.values()) card4.load();
    }
    /** @param {Board} board */
    showBar(board2) {
      const mark3 = JSON.stringify([board2.title, board2.filters, board2.datasets, board2.groups, board2.comments.length, wordsOf(board2.comments), this.still, this.look]);
      if (mark3 === this.barMark) return;
      this.barMark = mark3;
      const title = element("h2", "ellipsis", board2.title);
      const more2 = iconButton("dots", "More", () => openMenu(more2, this.boardMenu()));
      const parts2 = [iconButton("left", "All boards", () => changeView({ board: "", screen: "" })), title, ...this.look === "present" ? [] : [this.datasetPicker(board2), ...this.groupPicker(board2), this.labelField(board2)]];
      if (!this.still) parts2.push(button("Add block", () => addBlock(
        /** @type {Board} */
        this.board,
        this.grid?.bottom() ?? 0,
        (made) => this.take(made)
      ), "primary"));
      if (this.look !== "present") parts2.push(button(wordsOf(board2.comments), () => this.comments.open(
        /** @type {Board} */
        this.board,
        "",
        "The whole board"
      )), button("Share board", () => this.share()));
      parts2.push(button(this.look === "present" ? "Leave" : "Present", () => this.present()));
      if (!this.still) parts2.push(more2);
      this.bar.replaceChildren(...parts2);
    }
    /** @param {Board} board */
    datasetPicker(board2) {
      const names2 = [.../* @__PURE__ */ new Set(["", board2.filters.dataset ?? "", ...board2.datasets])];
      const picker = withAttributes(element("select", "boards-select", ...names2.map((name) => withAttributes(element("option", "", name || "no dataset"), { value: name }))), { "aria-label": "Dataset of the board" });
      picker.value = board2.filters.dataset ?? "";
      picker.disabled = this.still;
      picker.addEventListener("change", () => this.filter({ dataset: picker.value }));
      return picker;
    }
    /** @param {Board} board */
    labelField(board2) {
      const field = withAttributes(element("input", "boards-label"), { placeholder: "Label", "aria-label": "Narrow the board to a label", type: "search" });
      field.value = board2.filters.label ?? "";
      field.addEventListener("change", () => this.filter({ label: field.value.trim() }));
      return field;
    }
    /** Narrow the board to clips with a value of a property. @param {Board} board */
    groupPicker(board2) {
      const now6 = board2.filters.group ?? "";
      if (!board2.groups.length && !now6) return [];
      const offered2 = board2.groups.map(([column, values]) => withAttributes(element("optgroup", "", ...values.map((value) => withAttributes(element("option", "", value), { value: `${column}=${value}` }))), { label: column }));
      const offers = board2.groups.some(([column, values]) => values.some((value) => `${column}=${value}` === now6));
      const picker = withAttributes(element("select", "boards-select", withAttributes(element("option", "", "all clips"), { value: "" }), ...now6 && !offers ? [withAttributes(element("option", "", `${now6} (gone)`), { value: now6 })] : [], ...offered2), { "aria-label": "Narrow the board to a group of clips" });
      picker.value = now6;
      picker.addEventListener("change", () => this.filter({ group: picker.value }));
      return [picker];
    }
    /** Change some filters: for all, or where the board may not be changed for oneself alone. @param {Board["filters"]} some */
    filter(some) {
      const board2 = (
        /** @type {Board} */
        this.board
      );
      const filters = { ...board2.filters, ...some };
      if (this.still) this.show({ ...board2, filters });
      else this.change({ action: "filter", filters });
    }
    /** Fade what the filters leave out; the clips of a group are asked for where they may be others. @param {Board} board */
    async showFilters(board2) {
      const mark3 = JSON.stringify([board2.filters, board2.groups, board2.blocks.map(({ dataset: dataset2 }) => dataset2)]);
      if (mark3 === this.filterMark) return;
      this.filterMark = mark3;
      const group = board2.filters.group ?? "";
      this.narrow();
      const answer2 = group ? await ask2(`boards/${this.id}/group?of=${encodeURIComponent(group)}`).catch((error) => this.warn(error.message)) : null;
      if (this.filterMark !== mark3) return;
      this.among = answer2 ? Object.fromEntries(Object.entries(
        /** @type {Record<string, string[]>} */
        answer2.clips
      ).map(([name, clips]) => [name, new Set(clips)])) : null;
      this.narrow();
    }
    narrow() {
      for (const card4 of this.cards.values()) this.narrowOne(card4);
    }
    /** @param {Card} card */
    narrowOne(card4) {
      card4.drawn.narrow?.(this.board?.filters.label ?? "", this.among ? this.among[card4.block.dataset] ?? /* @__PURE__ */ new Set() : null);
    }
    /** @param {Board} board */
    showStale(board2) {
      const changed2 = board2.blocks.filter((block2) => block2.data === "changed");
      this.stale.replaceChildren(...changed2.length ? [
        element("span", "", `The data of ${changed2.length === 1 ? "a block has" : `${changed2.length} blocks has`} changed since ${changed2.length === 1 ? "it was" : "they were"} made.`),
        this.still ? "" : button("Recompute all", () => this.change({ action: "renew" }).then(() => {
          for (const card4 of this.cards.values()) if (kindOf(card4.block.kind)?.computes) card4.compute();
        }))
      ] : []);
    }
    /** Change the board; what the server gives back is shown. @param {Record<string, any>} body */
    async change(body2) {
      try {
        this.take(await ask2(`boards/${this.id}`, body2));
      } catch (error) {
        say(error instanceof Error ? error.message : String(error));
        await this.update(true);
      }
    }
    /** @param {Board} board */
    take(board2) {
      this.mark = "";
      this.show(board2);
    }
    /** @param {Record<string, number[]>} places */
    moved(places) {
      clearTimeout(this.moving);
      if (this.board) this.board = { ...this.board, blocks: this.board.blocks.map((block2) => ({ ...block2, ...asPlace(places[block2.id]) })) };
      this.moving = window.setTimeout(async () => {
        this.moving = 0;
        await this.change({ action: "move", places });
      }, SETTLED2);
    }
    /** @param {Card} card @param {Element} anchor */
    menu(card4, anchor) {
      const { block: block2 } = card4;
      openMenu(anchor, [
        ["Change", () => editBlock(
          /** @type {Board} */
          this.board,
          card4.block,
          (board2) => this.take(board2)
        )],
        ["Duplicate", () => this.change({ action: "add", block: { ...block2, id: "", y: block2.y + block2.h } })],
        ["Comment", () => this.comments.open(
          /** @type {Board} */
          this.board,
          block2.id,
          card4.name
        )],
        ["Remove", () => this.remove(block2, card4.name)]
      ]);
    }
    /** @param {BlockData} block @param {string} name */
    async remove(block2, name) {
      await this.change({ action: "remove", block: block2.id, version: block2.version });
      if (!this.cards.has(block2.id)) say(`“${name}” was removed.`, () => this.change({ action: "add", block: block2 }));
    }
    /** @returns {[string, () => void][]} */
    boardMenu() {
      const board2 = (
        /** @type {Board} */
        this.board
      );
      return [
        ["Rename", () => renameBoard(board2, () => this.update(true))],
        ["Duplicate", async () => {
          const copy2 = await ask2(`boards/${this.id}`, { action: "duplicate" });
          changeView({ board: copy2.id });
        }],
        ["Report", () => openReport(board2.filters.dataset || shown3.dataset, board2)],
        ["History", () => showHistory(`boards/${this.id}`, board2.title, (version) => this.change({ action: "restore", version }))],
        ["Delete", () => deleteBoard(board2, () => changeView({ board: "", screen: "" }))]
      ];
    }
    share() {
      const { links } = (
        /** @type {Board} */
        this.board
      );
      const row7 = (name, words4, address3) => {
        const field = withAttributes(element("input"), { readonly: "", "aria-label": name });
        field.value = location.origin + address3;
        return element("label", "boards-field", element("span", "", name), field, element("small", "muted", words4));
      };
      const parts2 = [row7("To look at", "Whoever has it sees this board and nothing else.", links.read)];
      if (links.edit) {
        parts2.push(row7("To change", "Whoever has it can change this board as well.", links.edit));
        parts2.push(button("Renew the links", () => this.change({ action: "renew-links" }).then(() => say("The links that were given away open this board no more."))));
      }
      const dialog2 = openWindow("Share this board", element("div", "boards-form", ...parts2));
      dialog2.querySelector("input")?.select();
    }
    async present() {
      const leaving = this.look === "present";
      if (leaving && document.fullscreenElement) await document.exitFullscreen().catch(() => {
      });
      if (!leaving) await document.documentElement.requestFullscreen?.().catch(() => {
      });
      changeView({ screen: leaving ? "" : "present" });
    }
  };
  var asPlace = (place5) => place5 ? { x: place5[0], y: place5[1], w: place5[2], h: place5[3] } : {};
  function placeOf(board2, id) {
    const block2 = board2?.blocks.find((one) => one.id === id);
    return block2 ? { x: block2.x, y: block2.y, w: block2.w, h: block2.h } : {};
  }

  // boards/ids.mjs
  var BOARDS_PLACE = "boards-place";
  var SAVE_VIEW = "save-view";
  var COMMENTS_BUTTON = "comments-button";

  // boards/places.mjs
  var FRESH2 = 5e3;
  var listing = null;
  var asked2 = 0;
  addPlaces(async () => {
    if (!listing || performance.now() - asked2 > FRESH2) [listing, asked2] = [refresh(), performance.now()];
    const { boards, views } = await listing;
    return [
      ...boards.map(({ id, title, note }) => ({ name: title, about: `board ${note}`.trim(), address: `/boards?board=${id}` })),
      ...views.map(({ title, note, tags, address: address3 }) => ({ name: title, about: ["view", note, ...tags.map((tag) => `#${tag}`)].filter(Boolean).join(" "), address: address3 }))
    ];
  });

  // boards/save_view.mjs
  document.addEventListener("click", async (event) => {
    if (!closest(event, `#${SAVE_VIEW}`)) return;
    const address3 = location.pathname + location.search;
    const picture2 = await pictureOfPage().catch(() => "");
    const title = find(PAGE)?.querySelector("h1, h2")?.textContent ?? "";
    const name = { name: "author", label: "Your name", value: person.name, hint: "where the server does not know it" };
    openForm("Save this view", [...viewFields({ title }), name], "Save", async (values) => {
      if (values.author.trim()) person.name = values.author;
      await ask2("views", { ...values, address: address3, picture: picture2, tags: tagsOf(values.tags) });
      notify("View saved", "It is listed on the Boards page.", "accent");
    });
  });

  // boards/boards.mjs
  var open = null;
  var last = { place: null, board: "", look: "", dark: false, ended: "" };
  register("boards", {
    // Called whenever something of what is shown changes, while the page is there.
    /** @param {View | null} view @param {string | null} dataset @param {Selection | null} selection @param {string} _theme @param {string | null} ended */
    show(view4, dataset2, selection, _theme, ended) {
      Object.assign(shown3, { view: view4 ?? {}, dataset: dataset2 ?? "", selection: selection ?? {} });
      const place5 = find(BOARDS_PLACE);
      if (!place5) return clientside.no_update;
      const now6 = { place: place5, board: view4?.board ?? "", look: view4?.screen ?? "", dark: isDark(), ended: ended ?? "" };
      const before2 = last;
      last = now6;
      document.getElementById(SHELL)?.classList.toggle("presenting", now6.look === "present" && now6.board !== "");
      if (now6.place !== before2.place || now6.board !== before2.board || now6.look !== before2.look) {
        open?.close();
        open = null;
        if (now6.board) {
          open = new OpenBoard(place5, now6.board, now6.look);
          open.open();
        } else showList(place5).catch((error) => place5.replaceChildren(element("p", "boards-warning", error.message)));
      } else if (now6.ended !== before2.ended) open?.reload();
      if (now6.dark !== before2.dark) requestAnimationFrame(() => open?.recolour());
      open?.light();
      return clientside.no_update;
    }
  });
  new MutationObserver(() => {
    if (find(BOARDS_PLACE)) return;
    document.getElementById(SHELL)?.classList.remove("presenting");
    open?.close();
    open = null;
    last = { ...last, place: null };
  }).observe(document.documentElement, { childList: true, subtree: true });

  // boards/discussion.mjs
  var EVERY2 = 2e3;
  var SETTLED3 = 400;
  var Panel = class extends Comments {
    constructor() {
      super(() => this.update());
      this.node.classList.add("discussion");
      this.about = null;
      this.asked = "";
      this.timer = 0;
    }
    place() {
      const { place: place5 = "", moments = false } = this.about ?? {};
      return moments ? `${place5}/${frameNow(place5)}` : place5;
    }
    /** @param {CommentData} comment */
    said(comment) {
      const node = super.said(comment);
      if (comment.frame !== void 0) node.prepend(button(`at ${comment.seconds?.toFixed(2)} s`, () => this.seek(Number(comment.frame)), "boards-moment"));
      return node;
    }
    /** @param {number} frame */
    seek(frame) {
      const clip = this.about?.place.replace(/^moment:[^/]+\//, "");
      if (clip) player.seek({ clip, frame });
    }
    /** Ask what is said about what is selected now. */
    async update() {
      const query2 = location.search;
      const answer2 = (
        /** @type {Discussion | null} */
        await ask2(`comments${query2 || "?"}`).catch(() => void 0)
      );
      if (query2 !== location.search || answer2 === void 0) return;
      const other = answer2?.place !== this.about?.place;
      this.about = answer2?.place ? answer2 : null;
      const open6 = (this.about?.comments ?? []).filter((comment) => !comment.resolved && !comment.parent).length;
      const label = find(COMMENTS_BUTTON);
      if (label) {
        label.hidden = !this.about;
        label.dataset.count = open6 ? String(open6) : "";
        label.title = this.about ? `What is said about ${this.about.title}` : "";
      }
      if (!this.about) this.close();
      else if (!this.node.hidden) {
        if (other) this.open(this.asBoard(), "", this.about.title);
        else this.show(this.asBoard());
      }
    }
    /** What the list of comments needs to know of a board. */
    asBoard() {
      return (
        /** @type {Board} */
        /** @type {unknown} */
        { ...this.about }
      );
    }
    poll() {
      clearTimeout(this.timer);
      this.timer = window.setTimeout(async () => {
        if (this.node.hidden) return;
        if (document.visibilityState === "visible") await this.update();
        this.poll();
      }, EVERY2);
    }
  };
  var panel = new Panel();
  document.addEventListener("click", async (event) => {
    if (!closest(event, `#${COMMENTS_BUTTON}`)) return;
    if (!panel.node.hidden) {
      panel.close();
      return;
    }
    document.body.append(panel.node);
    await panel.update();
    if (!panel.about) return;
    panel.open(panel.asBoard(), "", panel.about.title);
    panel.poll();
  });
  var waiting = 0;
  register("discussion", {
    // Called with the address, which says what is selected.
    look() {
      const query2 = location.search.replace(/&?(time|camera|speed|layout)=[^&]*/g, "");
      if (query2 === panel.asked) return clientside.no_update;
      panel.asked = query2;
      clearTimeout(waiting);
      waiting = window.setTimeout(() => panel.update(), SETTLED3);
      return clientside.no_update;
    }
  });
  function frameNow(place5) {
    const clip = place5.replace(/^moment:[^/]+\//, "");
    for (let k = 0, item; k < 48 && (item = player.frameOf(k)); k++) if (item.clip === clip) return Math.round(item.frame);
    return 0;
  }

  // blocks/player.mjs
  var calm2 = () => matchMedia("(prefers-reduced-motion: reduce)").matches;
  var Player = class {
    /** @param {HTMLCanvasElement} canvas */
    constructor(canvas) {
      this.canvas = canvas;
      this.scene = new Scene(canvas, readTheme(canvas));
      this.camera = new Camera();
      this.clock = new Clock();
      this.traces = new Traces();
      this.figures = [];
      this.layout = "overlay";
      this.closed = false;
      this.dirty = true;
      this.before = 0;
      this.onFrame = () => {
      };
      this.sizes = new ResizeObserver(() => this.fit());
      this.sizes.observe(canvas);
      this.takeHand();
      this.recolour();
      this.frame = (now6) => this.tick(now6);
      requestAnimationFrame(this.frame);
    }
    close() {
      this.closed = true;
      this.sizes.disconnect();
    }
    /** @param {Figure[]} figures */
    show(figures) {
      this.figures = figures;
      nameFigures(figures);
      this.clock.duration = makeTimeline(figures, "warp", this.layout).duration;
      this.clock.seek(0);
      this.camera.reset(homeView(figures, this.layout));
      this.traces.suit(figures);
      this.place();
      this.recolour();
      if (calm2()) this.clock.playing = false;
      else this.clock.play();
    }
    /** @param {string} layout "overlay" or "side" */
    lay(layout) {
      this.layout = layout;
      this.camera.reset(homeView(this.figures, layout));
      this.place();
    }
    place() {
      this.scene.resize();
      const aspect = this.scene.width / Math.max(this.scene.height, 1);
      this.scene.ground.shelves = placeFigures(this.figures, this.layout, aspect, this.clock.duration);
      this.scene.bodies.collect(this.figures, this.layout === "overlay");
      this.fit();
      this.clock.jumped = true;
    }
    fit() {
      this.scene.resize();
      if (this.figures.length) {
        const { cloud, radius } = measureStage(this.figures, this.clock.duration);
        this.camera.fit(cloud, this.scene.width / Math.max(this.scene.height, 1));
        this.scene.ground.radius = Math.max(2.2, radius * 1.5 + 0.6);
      }
      this.dirty = true;
    }
    recolour() {
      this.scene.setTheme(readTheme(this.canvas));
      this.figures.forEach((figure3, k) => {
        figure3.colours = figureColours(this.scene.theme, k, this.figures.length, figure3.item.colour);
        figure3.shades = shades(this.scene.theme, figure3.colours, 0);
      });
      this.dirty = true;
    }
    /** @param {number} share of the time, 0 to 1 */
    seek(share2) {
      this.clock.seek(share2 * this.clock.duration);
      this.dirty = true;
    }
    toggle() {
      if (this.clock.playing) this.clock.playing = false;
      else this.clock.play();
      this.dirty = true;
    }
    takeHand() {
      const { canvas } = this;
      canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
      canvas.addEventListener("pointermove", (event) => {
        if (!(event.buttons & 3)) return;
        if (event.shiftKey || event.buttons & 2) this.camera.shift(event.movementX, event.movementY, canvas.clientHeight);
        else this.camera.orbit(event.movementX / 160, event.movementY / 200);
        this.dirty = true;
      });
      canvas.addEventListener("contextmenu", (event) => event.preventDefault());
      canvas.addEventListener("wheel", (event) => {
        if (!event.ctrlKey && document.activeElement !== canvas) return;
        event.preventDefault();
        this.camera.zoom(event.deltaY > 0 ? 1.1 : 1 / 1.1);
        this.dirty = true;
      }, { passive: false });
      canvas.addEventListener("keydown", (event) => this.key(event));
    }
    /** @param {KeyboardEvent} event */
    key(event) {
      const keys = {
        " ": () => this.toggle(),
        ArrowLeft: () => this.camera.orbit(-0.1, 0),
        ArrowRight: () => this.camera.orbit(0.1, 0),
        "+": () => this.camera.zoom(1 / 1.15),
        "-": () => this.camera.zoom(1.15)
      };
      if (!keys[event.key] || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      keys[event.key]();
      this.dirty = true;
    }
    /** @param {number} now */
    tick(now6) {
      if (this.closed) return;
      requestAnimationFrame(this.frame);
      const seconds = Math.min(Math.max((now6 - this.before) / 1e3, 0), 0.25);
      this.before = now6;
      if (this.clock.playing) this.clock.advance(seconds);
      if (!this.clock.playing && !this.dirty) return;
      this.dirty = false;
      this.paint(this.clock.playing ? seconds : Infinity);
      this.onFrame();
    }
    /**
     * Paint the moment of the clock.
     * @param {number} seconds since the picture before, while which the camera follows; Infinity: it is there at once
     */
    paint(seconds) {
      for (const figure3 of this.figures) if (figure3.visible) figure3.pose(this.clock.time);
      if (this.figures.length) {
        const [x, z] = groundCentre(this.figures, [0, 0]);
        if (this.camera.follow) this.camera.track(x, z, seconds, this.clock.jumped || seconds === Infinity);
        this.clock.jumped = false;
      }
      this.scene.paint(this.camera, this.figures, this.traces, this.clock, this.layout === "overlay");
    }
  };

  // boards/own_blocks.mjs
  function drawText(place5, { html: html2 }) {
    const text = element("div", "block-text");
    text.innerHTML = html2;
    place5.append(text);
    return {};
  }
  function drawStage(place5, { request: request5 }, context) {
    const canvas = element("canvas", "block-canvas");
    canvas.tabIndex = 0;
    canvas.setAttribute("aria-label", `${request5.title ?? "Motion"}: drag to turn, space to stop`);
    place5.append(canvas);
    const player2 = new Player(canvas);
    player2.layout = request5.layout === "side" ? "side" : "overlay";
    context.figures(request5.items, request5).then((figures) => {
      if (figures.length) player2.show(figures);
      else place5.replaceChildren(element("p", "muted", "The motion that plays here is not there."));
    });
    return { recolour: () => player2.recolour(), close: () => player2.close() };
  }
  function drawView(place5, { title, note, tags, address: address3, author, picture: picture2 }, context) {
    const image = picture2 ? withAttributes(element("img", "block-view-picture"), { src: picture2, alt: `Picture of ${title}` }) : null;
    const link2 = context.opens ? withAttributes(element("a", "text-link", title), { href: address3 }) : element("strong", "", title);
    place5.append(element("div", "block-view", image, link2, note && element("p", "", note), element("p", "muted", [author, ...tags.map((tag) => `#${tag}`)].filter(Boolean).join(" · "))));
    return {};
  }

  // blocks/tip.mjs
  var box = null;
  function tipBox() {
    if (!box || !box.isConnected) {
      box = element("div", "block-tip");
      box.setAttribute("role", "tooltip");
      box.hidden = true;
      document.body.append(box);
    }
    return box;
  }
  function showTip(at3, ...parts2) {
    const tip = tipBox();
    tip.replaceChildren(...parts2.map((part2) => typeof part2 === "string" ? element("div", "", part2) : part2));
    tip.hidden = false;
    const { offsetWidth: width, offsetHeight: height } = tip;
    tip.style.left = `${Math.max(4, Math.min(at3.clientX + 14, innerWidth - width - 8))}px`;
    tip.style.top = `${at3.clientY + 18 + height > innerHeight ? Math.max(4, at3.clientY - height - 10) : at3.clientY + 18}px`;
  }
  function hideTip() {
    if (box) box.hidden = true;
  }
  function tipOn(node, parts2) {
    node.addEventListener("pointermove", (event) => showTip(
      /** @type {PointerEvent} */
      event,
      ...parts2()
    ));
    node.addEventListener("pointerleave", hideTip);
    node.addEventListener("focus", () => {
      const { left, bottom } = node.getBoundingClientRect();
      if (node.matches(":focus-visible")) showTip({ clientX: left, clientY: bottom - 12 }, ...parts2());
    });
    node.addEventListener("blur", hideTip);
    return node;
  }
  function asButton(node, name, act2) {
    node.setAttribute("role", "button");
    node.setAttribute("tabindex", "0");
    node.setAttribute("aria-label", name);
    node.addEventListener("click", act2);
    node.addEventListener("keydown", (event) => {
      const { key } = (
        /** @type {KeyboardEvent} */
        event
      );
      if (key !== "Enter" && key !== " ") return;
      event.preventDefault();
      act2(event);
    });
    return node;
  }

  // blocks/rows.mjs
  var [LANE2, GAP] = [14, 3];
  function legend2(names2, colours) {
    return element("div", "block-legend", ...names2.map((name, k) => {
      const key = element("span", "block-key", name);
      key.style.setProperty("--colour", colours[k]);
      return key;
    }));
  }
  var isFaint = (among2, clip) => among2 !== null && !among2.has(clip);
  function drawRows(place5, tracks) {
    const longest2 = Math.max(...tracks.map(({ seconds }) => seconds), 1e-9);
    const drawn8 = [];
    const rows2 = tracks.map((track) => {
      const height = Math.max(track.lanes.length, 1) * (LANE2 + GAP);
      const svg = svgElement("svg", { class: "block-track", viewBox: `0 0 1000 ${height}`, height, preserveAspectRatio: "none" });
      track.lanes.forEach((lane, row7) => {
        for (const stretch of lane) {
          const [x, width] = [1e3 * stretch.start / longest2, 1e3 * (stretch.end - stretch.start) / longest2];
          const node = svgElement("rect", { x, y: row7 * (LANE2 + GAP), width: Math.max(width - 0.6, 0.8), height: LANE2, fill: stretch.colour, class: "block-stretch" });
          tipOn(node, () => [stretch.tip]);
          asButton(node, stretch.tip, stretch.choose);
          node.setAttribute("tabindex", "-1");
          drawn8.push([stretch, node, [track.clip, stretch.start * track.fps, stretch.end * track.fps]]);
          svg.append(node);
        }
      });
      const name = element("span", "block-row-name ellipsis", track.brief);
      name.title = track.clip;
      return { clip: track.clip, node: element("div", "block-row", name, svg, element("span", "block-row-end number", clock(track.seconds))) };
    });
    place5.append(element("div", "block-rows", ...rows2.map(({ node }) => node)));
    return (keys, motion, clip, among2) => {
      const lit4 = drawn8.map(([{ key }, , segment]) => keys.size ? keys.has(key) : isIn(segment, motion));
      const some = lit4.includes(true);
      drawn8.forEach(([, node], k) => node.classList.toggle("faint", some && !lit4[k]));
      for (const row7 of rows2) {
        row7.node.classList.toggle("chosen", row7.clip === clip);
        row7.node.classList.toggle("faint", isFaint(among2, row7.clip));
      }
    };
  }

  // grammar/actions_block.mjs
  function drawActions(place5, content, context) {
    const tracks = content.rows.map((row7) => ({
      clip: row7.clip,
      fps: row7.fps,
      brief: row7.brief,
      seconds: row7.seconds,
      lanes: [row7.pieces.map(([start3, end, id, number2]) => {
        const action = content.actions[id];
        return {
          start: start3,
          end,
          colour: action.colour,
          ink: action.ink,
          text: action.short,
          key: `action ${id}`,
          tip: `${action.name}, ${clock(start3)} to ${clock(end)} (${action.count} in all)`,
          choose: () => context.select({ action: id }, {
            title: action.name,
            items: action.segments.map(([clip2, from, to]) => ({ clip: clip2, start: from, end: to, label: `${clip2}, ${number2 + 1}` }))
          })
        };
      })]
    }));
    const lit4 = drawRows(place5, tracks);
    let [label, clip] = [
      "",
      /** @type {string | undefined} */
      void 0
    ];
    let keys = /* @__PURE__ */ new Set();
    let motion = [];
    let among2 = null;
    const show6 = () => {
      const wanted2 = label ? content.actions.filter((action) => isMostly(action.label, label)).map(({ id }) => `action ${id}`) : [];
      lit4(/* @__PURE__ */ new Set([...keys, ...wanted2]), motion, clip, among2);
    };
    return {
      motion: ({ action }) => content.actions.find(({ id }) => id === action)?.segments,
      light(selection, named3) {
        keys = new Set(selection.action === void 0 ? [] : [`action ${selection.action}`]);
        motion = named3;
        ({ clip } = selection);
        show6();
      },
      narrow(wanted2, clips) {
        [label, among2] = [wanted2, clips];
        show6();
      }
    };
  }

  // blocks/table.mjs
  function tableRow(cells, strip, name, act2) {
    const picture2 = element("td", "block-strip");
    picture2.innerHTML = strip;
    return asButton(element("tr", "", ...cells.map((cell2, k) => element("td", k && k < 4 ? "number" : "", cell2 || " ")), picture2), name, act2);
  }
  function tableOf(heads, rows2, note) {
    return element("div", "block-table", element("table", "", element("thead", "", element("tr", "", ...heads.map((head3, k) => element("th", k && k < 4 ? "number" : "", head3)))), element("tbody", "", ...rows2)), note && element("p", "muted", note));
  }

  // library/overview_block.mjs
  function drawOverview(place5, { facts, clips, more: more2 }, context) {
    place5.append(element("dl", "block-facts", ...facts.map(([name, value]) => element("div", "", element("dt", "", name), element("dd", "number", value)))));
    const rows2 = clips.map((clip) => tableRow(
      [clip.name, clock(clip.seconds), `${clip.frames.toLocaleString("en")}`, `${clip.fps}`, clip.labels + (clip.verdict === "ok" ? "" : ` (${clip.verdict})`)],
      clip.strip,
      `Play ${clip.name}`,
      () => context.select({ clip: clip.name }, { title: clip.name, items: [{ clip: clip.name, start: 0, end: clip.frames, label: clip.name }] })
    ));
    place5.append(tableOf(["Clip", "Duration", "Frames", "Rate", "Labels", "Motion"], rows2, more2 ? `${plural(more2, "more clip")} not listed.` : ""));
    return {
      light(_selection, motion) {
        const chosen3 = new Set(motion.map(([clip]) => clip));
        clips.forEach(({ name }, k) => rows2[k].classList.toggle("chosen", chosen3.has(name)));
      },
      narrow: (label, among2) => clips.forEach(({ name, labels: labels2 }, k) => rows2[k].classList.toggle("faint", isFaint(among2, name) || Boolean(label) && !labels2.split(", ").includes(label)))
    };
  }

  // library/tracks_block.mjs
  function drawTracks(place5, content, context) {
    const tracks = content.rows.map((row7) => {
      const choose6 = (from, to) => () => {
        const [start3, end] = [Math.round(from * row7.fps), Math.round(to * row7.fps)];
        context.select({ clip: row7.clip, start: start3, end }, { title: row7.clip, items: [{ clip: row7.clip, start: start3, end, label: row7.clip }] });
      };
      const labels2 = row7.labels.map(([start3, end, action]) => ({
        start: start3,
        end,
        colour: content.colours[action],
        text: content.actions[action],
        key: `label ${content.actions[action]}`,
        tip: `${content.actions[action]}, ${clock(start3)} to ${clock(end)}`,
        choose: choose6(start3, end)
      }));
      const motions2 = row7.motions.map(([start3, end, motif, number2]) => ({
        start: start3,
        end,
        colour: content.motifs[motif].colour,
        text: String(motif),
        key: `motif ${motif}`,
        tip: `${content.motifs[motif].name}, motion ${number2 + 1}, ${clock(start3)} to ${clock(end)}`,
        choose: () => context.select({ motif, motion: number2 }, {
          title: `${content.motifs[motif].name}, motion ${number2 + 1}`,
          items: [{ clip: row7.clip, start: Math.round(start3 * row7.fps), end: Math.round(end * row7.fps), label: row7.clip }]
        })
      }));
      return { clip: row7.clip, fps: row7.fps, brief: row7.brief, seconds: row7.seconds, lanes: [labels2, motions2].filter((lane) => lane.length) };
    });
    const lit4 = drawRows(place5, tracks);
    if (content.actions.length) place5.append(legend2(content.actions, content.colours));
    let [wanted2, clip] = [
      "",
      /** @type {string | undefined} */
      void 0
    ];
    let keys = /* @__PURE__ */ new Set();
    let among2 = null;
    let motion = [];
    const show6 = () => lit4(wanted2 ? /* @__PURE__ */ new Set([...keys, `label ${wanted2}`]) : keys, motion, clip, among2);
    return {
      motion: (selection) => motionsOf(content, motifsIn(selection), selection.motion),
      light(selection, named3) {
        motion = named3;
        keys = new Set([...motifsIn(selection)].map((motif) => `motif ${motif}`));
        ({ clip } = selection);
        show6();
      },
      narrow(label, clips) {
        [wanted2, among2] = [label, clips];
        show6();
      }
    };
  }
  function motionsOf({ rows: rows2 }, motifs2, wanted2) {
    const found = rows2.flatMap(({ clip, fps, motions: motions2 }) => motions2.filter(([, , motif, number2]) => motifs2.has(motif) && (wanted2 === void 0 || wanted2 === number2)).map(([start3, end]) => (
      /** @type {Segment} */
      [clip, Math.round(start3 * fps), Math.round(end * fps)]
    )));
    return found.length ? found : void 0;
  }

  // blocks/pan_zoom.mjs
  var [CLOSEST, STEP] = [12, 1.3];
  function panZoom(svg, whole3) {
    let [x, y, width, height] = whole3;
    const show6 = () => svg.setAttribute("viewBox", `${x} ${y} ${width} ${height}`);
    const scale3 = () => Math.min(svg.clientWidth / width, svg.clientHeight / height) || 1;
    function zoom4(factor, px = 0.5, py = 0.5) {
      const next2 = clamp(width / factor, whole3[2] / CLOSEST, whole3[2] * 1.5);
      const real = width / next2;
      x += px * (width - next2);
      y += py * (height - height / real);
      [width, height] = [next2, height / real];
      show6();
    }
    const reset2 = () => {
      [x, y, width, height] = whole3;
      show6();
    };
    function move6(dx, dy) {
      x = clamp(x - dx / scale3(), whole3[0] - width / 2, whole3[0] + whole3[2] - width / 2);
      y = clamp(y - dy / scale3(), whole3[1] - height / 2, whole3[1] + whole3[3] - height / 2);
      show6();
    }
    svg.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && !svg.matches(":focus-within, :focus")) return;
      event.preventDefault();
      const box4 = svg.getBoundingClientRect();
      zoom4(event.deltaY < 0 ? 1.15 : 1 / 1.15, (event.clientX - box4.left) / box4.width, (event.clientY - box4.top) / box4.height);
    }, { passive: false });
    let drag2 = null;
    svg.addEventListener("pointerdown", (event) => {
      if (event.button === 0) drag2 = { x: event.clientX, y: event.clientY, moved: false };
    });
    svg.addEventListener("pointermove", (event) => {
      if (!drag2 || !(event.buttons & 1)) return;
      const [dx, dy] = [event.clientX - drag2.x, event.clientY - drag2.y];
      if (!drag2.moved && Math.hypot(dx, dy) < 4) return;
      if (!drag2.moved) svg.setPointerCapture(event.pointerId);
      drag2 = { x: event.clientX, y: event.clientY, moved: true };
      move6(dx, dy);
    });
    svg.addEventListener("click", (event) => {
      if (drag2?.moved) event.stopPropagation();
      drag2 = null;
    }, { capture: true });
    svg.addEventListener("dblclick", reset2);
    svg.addEventListener("keydown", (event) => {
      const keys = {
        ArrowLeft: () => move6(40, 0),
        ArrowRight: () => move6(-40, 0),
        ArrowUp: () => move6(0, 40),
        ArrowDown: () => move6(0, -40),
        "+": () => zoom4(STEP),
        "=": () => zoom4(STEP),
        "-": () => zoom4(1 / STEP),
        0: reset2
      };
      if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
      event.preventDefault();
      event.stopPropagation();
      keys[event.key]();
    });
    show6();
    return zoomButtons(zoom4, reset2);
  }
  function zoomButtons(zoom4, reset2) {
    const kinds2 = [["+", "Closer", () => zoom4(STEP)], ["−", "Further", () => zoom4(1 / STEP)], ["⤢", "Show all", reset2]];
    return element("div", "block-zoom", ...kinds2.map(([sign, name, act2]) => {
      const button5 = element("button", "", sign);
      button5.type = "button";
      button5.title = name;
      button5.setAttribute("aria-label", name);
      button5.addEventListener("click", act2);
      return button5;
    }));
  }

  // motion_map/posture_block.mjs
  var [YAW, PITCH] = [35 * Math.PI / 180, 8 * Math.PI / 180];
  function readPostures(text) {
    const bytes2 = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    return new Int16Array(bytes2.buffer);
  }
  function drawPosture({ parents, sides, roles }, postures, node, size = 120) {
    const n = parents.length;
    const seen3 = (joint) => {
      const at3 = 3 * (node * n + joint);
      const [x, y, z] = joint < 0 ? [0, 0, 0] : [postures[at3], postures[at3 + 1], postures[at3 + 2]];
      const away = Math.cos(YAW) * z - Math.sin(YAW) * x;
      return [Math.cos(YAW) * x + Math.sin(YAW) * z, -(y * Math.cos(PITCH) - away * Math.sin(PITCH)), away];
    };
    const points = parents.map((_, joint) => seen3(joint));
    const lows = [0, 1].map((k) => Math.min(0, ...points.map((point) => point[k])) - 160);
    const highs = [0, 1].map((k) => Math.max(0, ...points.map((point) => point[k])) + 90);
    const svg = svgElement("svg", { class: "block-posture", viewBox: `${lows[0]} ${lows[1]} ${highs[0] - lows[0]} ${highs[1] - lows[1]}`, width: size, height: size });
    const bones = parents.map((parent, joint) => ({ joint, side: trunk(roles[joint]) ? "centre" : sides[joint], from: seen3(parent), to: points[joint] }));
    for (const { from, to, side } of bones.sort((a, b) => a.from[2] + a.to[2] - b.from[2] - b.to[2])) {
      svg.append(svgElement("path", { d: `M${from[0]} ${from[1]}L${to[0]} ${to[1]}`, class: `block-bone block-${side}` }));
    }
    const head3 = roles.indexOf("head");
    if (head3 >= 0) svg.append(svgElement("circle", { cx: points[head3][0], cy: points[head3][1] - 85, r: 100, class: "block-skull" }));
    return svg;
  }
  var trunk = (role) => /_(clavicle|shoulder|hip)$/.test(role);

  // motion_map/map_block.mjs
  function drawMap(place5, content, context) {
    const [nx, ny] = content.grid;
    const postures = readPostures(content.postures);
    const highest = Math.max(...content.heights, 1e-9);
    const svg = svgElement("svg", { class: "block-map", tabindex: 0, role: "application", "aria-label": "Motion map: arrow keys move over it, Enter plays what passes" });
    const ground = svgElement("g", { class: "block-nodes" });
    const squares = content.heights.map((height, node) => svgElement("rect", { x: Math.floor(node / ny) - 0.5, y: node % ny - 0.5, width: 1.02, height: 1.02, "fill-opacity": (height / highest).toFixed(3) }));
    ground.append(...squares);
    const stays = staysOf(content);
    const icons = svgElement("g", { class: "block-icons" });
    const mark3 = svgElement("rect", { class: "block-mark", width: 1, height: 1, x: -9, y: -9 });
    svg.append(ground, icons, mark3);
    const zoom4 = panZoom(svg, [-0.5, -0.5, nx, ny]);
    place5.append(svg, zoom4);
    const paint2 = () => {
      icons.innerHTML = content.icons[context.dark() ? "dark" : "light"];
      const picture2 = icons.firstElementChild;
      for (const [name, value] of Object.entries({ x: -0.5, y: -0.5, width: nx, height: ny })) picture2?.setAttribute(name, String(value));
    };
    paint2();
    let current3 = -1;
    const point = (x, y) => {
      current3 = clamp(x, 0, nx - 1) * ny + clamp(y, 0, ny - 1);
      mark3.setAttribute("x", String(Math.floor(current3 / ny) - 0.5));
      mark3.setAttribute("y", String(current3 % ny - 0.5));
    };
    const tell5 = (at3) => showTip(
      at3,
      drawPosture(content, postures, current3),
      `${content.seconds[current3].toFixed(1)} s of motion here${content.passes[current3].length ? ", click to play" : ""}`
    );
    const play8 = () => {
      const passes = current3 < 0 ? [] : content.passes[current3];
      if (!passes.length) return;
      const [clip, start3, end] = passes[0];
      context.select({ clip, start: start3, end }, {
        title: `Motion through node ${Math.floor(current3 / ny)}, ${current3 % ny}`,
        items: passes.map(([name, from, to]) => ({ clip: name, start: from, end: to, label: name }))
      });
    };
    svg.addEventListener("pointermove", (event) => {
      const matrix = svg.getScreenCTM()?.inverse();
      if (!matrix || event.buttons) return;
      const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
      if (x < -0.5 || y < -0.5 || x > nx - 0.5 || y > ny - 0.5) return hideTip();
      point(Math.round(x), Math.round(y));
      tell5(event);
    });
    svg.addEventListener("pointerleave", hideTip);
    svg.addEventListener("blur", hideTip);
    svg.addEventListener("click", play8);
    svg.addEventListener("keydown", (event) => {
      const steps2 = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
      if (event.key === "Enter") play8();
      const step3 = steps2[event.key];
      if (!step3) return;
      event.preventDefault();
      event.stopImmediatePropagation();
      point(Math.floor(Math.max(current3, 0) / ny) + step3[0], Math.max(current3, 0) % ny + step3[1]);
      const box4 = mark3.getBoundingClientRect();
      tell5({ clientX: box4.right, clientY: box4.bottom });
    }, { capture: true });
    if (!content.heights.length) place5.append(element("p", "muted", "This map has no nodes."));
    return {
      recolour: paint2,
      light(selection, motion) {
        const passed = new Set(motion.length ? stays.filter(({ at: at3 }) => isIn(at3, motion)).map(({ node: node2 }) => node2) : []);
        squares.forEach((square, k) => square.classList.toggle("lit", passed.has(k)));
        const { clip, start: start3, end } = selection;
        const node = clip === void 0 ? -1 : content.passes.findIndex((passes) => passes.some(([name, from, to]) => name === clip && from === start3 && to === end));
        if (node >= 0) point(Math.floor(node / ny), node % ny);
      },
      narrow(label, among2) {
        const fit2 = stays.filter((stay) => (!label || stay.label === label) && (!among2 || among2.has(stay.at[0])));
        const nodes = new Set(fit2.map(({ node }) => node));
        const all = !stays.length || !label && !among2;
        squares.forEach((square, k) => square.classList.toggle("faint", !all && !nodes.has(k)));
      }
    };
  }
  function staysOf({ stays = [], clips = [], labels: labels2 = [] }) {
    return Array.from({ length: stays.length / 5 }, (_, k) => {
      const [clip, node, start3, end, label] = stays.slice(5 * k, 5 * k + 5);
      return { node, at: [clips[clip], start3, end], label: labels2[label] ?? "" };
    });
  }

  // motifs/motif_blocks.mjs
  var playingOf = (motif) => ({
    title: `${motif.name}, ${motif.count} motions`,
    items: motif.motions.map(([clip, start3, end], k) => ({ clip, start: start3, end, label: clip, warp: motif.warps[k] ?? null }))
  });
  var choose = (context, motif) => context.select({ motif: motif.id }, playingOf(motif));
  var fits = (motif, label, among2) => (!label || isMostly(motif.label, label)) && (!among2 || motif.motions.some(([clip]) => among2.has(clip)));
  var factsOf = (motif) => [
    motif.name,
    `${motif.count} motions of ${motif.seconds.toFixed(1)} s${motif.label ? `, mostly ${motif.label}` : ""}`
  ];
  function drawMotifs(place5, { motifs: motifs2, more: more2 }, context) {
    const rows2 = motifs2.map((motif) => tableRow(
      [motif.name, String(motif.count), motif.seconds.toFixed(1), String(motif.clips ?? ""), [motif.label, motif.note].filter(Boolean).join(" · ")],
      motif.strip ?? "",
      `Play ${motif.name}`,
      () => choose(context, motif)
    ));
    place5.append(tableOf(["Motif", "Motions", "Seconds", "Clips", "Mostly", "Motion"], rows2, more2 ? `${plural(more2, "more motif")} not listed.` : ""));
    return {
      motion: (selection) => motionOf(selection, motifs2),
      light(selection, motion) {
        const chosen3 = motifsToLight(selection, motion, motifs2);
        motifs2.forEach(({ id }, k) => rows2[k].classList.toggle("chosen", chosen3.has(id)));
      },
      narrow: (label, among2) => motifs2.forEach((motif, k) => rows2[k].classList.toggle("faint", !fits(motif, label, among2)))
    };
  }
  function drawNumbers(place5, { figures }) {
    place5.append(element("div", "block-numbers", ...figures.map(([name, value, unit2, words4]) => {
      const tile = element("div", "block-number", element("span", "block-number-value number", value, unit2 && element("small", "", ` ${unit2}`)), element("span", "muted", name));
      tile.tabIndex = 0;
      return tipOn(tile, () => [words4]);
    })));
    return {};
  }

  // motifs/graph_block.mjs
  var AIR = 46;
  function drawGraph(place5, { motifs: motifs2, edges }, context) {
    if (!motifs2.length) {
      place5.append(element("p", "muted", "No movement recurs with these settings."));
      return {};
    }
    const byId = new Map(motifs2.map((motif) => [motif.id, motif]));
    const svg = svgElement("svg", { class: "block-graph", tabindex: 0, role: "group", "aria-label": "Motif graph" });
    svg.append(svgElement("defs", {}, svgElement("marker", {
      id: "block-arrow",
      viewBox: "0 0 8 8",
      refX: 7,
      refY: 4,
      markerWidth: 9,
      markerHeight: 9,
      orient: "auto",
      markerUnits: "userSpaceOnUse"
    }, svgElement("path", { d: "M0 0L8 4L0 8z", class: "block-arrow" }))));
    const ways = /* @__PURE__ */ new Map();
    for (const [source, target2, count, width] of edges) {
      const [from, to] = [byId.get(source), byId.get(target2)];
      if (!from || !to) continue;
      const line3 = svgElement("path", { d: way(from, to), class: "block-edge", "stroke-width": width, "marker-end": "url(#block-arrow)" });
      tipOn(line3, () => [`${from.name} to ${to.name}`, `${count} times`]);
      ways.set(line3, [source, target2]);
      svg.append(line3);
    }
    const boxes = new Map(motifs2.map((motif) => [motif.id, box2(motif, context)]));
    svg.append(...boxes.values());
    place5.append(svg, panZoom(svg, around2(motifs2)));
    return {
      narrow(label, among2) {
        for (const motif of motifs2) boxes.get(motif.id)?.classList.toggle("faint", !fits(motif, label, among2));
      },
      motion: (selection) => motionOf(selection, motifs2),
      light(selection, motion) {
        const chosen3 = motifsToLight(selection, motion, motifs2);
        for (const [id, node] of boxes) node.classList.toggle("chosen", chosen3.has(id));
        for (const [line3, [source, target2]] of ways) {
          const near = selection.edge ? selection.edge === `${source}-${target2}` : chosen3.has(source) || chosen3.has(target2);
          line3.classList.toggle("near", near);
        }
        svg.classList.toggle("lit", chosen3.size > 0 && motifs2.some((motif) => chosen3.has(motif.id)));
      }
    };
  }
  function box2(motif, context) {
    const [w, h] = motif.size;
    const side = 0.86 * Math.min(w, h);
    const node = svgElement(
      "g",
      { class: "block-motif", transform: `translate(${motif.place[0]} ${motif.place[1]})` },
      svgElement("rect", { x: -w / 2, y: -h / 2, width: w, height: h, rx: 8, stroke: motif.part })
    );
    const picture2 = svgElement("g", {});
    picture2.innerHTML = motif.icon;
    const icon2 = picture2.firstElementChild;
    if (icon2) withAttributes(icon2, { x: -side / 2, y: -side / 2, width: side, height: side, "aria-hidden": "true" });
    node.append(picture2, svgElement("text", { y: h / 2 + 15, "text-anchor": "middle" }, `${motif.id} · ${motif.count}×`));
    tipOn(node, () => factsOf(motif));
    return asButton(node, factsOf(motif).join(", "), () => choose(context, motif));
  }
  function way(from, to) {
    const [[x1, y1], [x2, y2]] = [from.place, to.place];
    if (from === to) {
      const [w, h] = from.size;
      return `M${x1 - w / 4} ${y1 - h / 2}C${x1 - w / 2} ${y1 - h / 2 - 36} ${x1 + w / 2} ${y1 - h / 2 - 36} ${x1 + w / 4} ${y1 - h / 2}`;
    }
    const [dx, dy] = [x2 - x1, y2 - y1];
    const length = Math.hypot(dx, dy) || 1;
    const bend = Math.min(26, 0.12 * length);
    const [mx, my] = [(x1 + x2) / 2 - dy / length * bend, (y1 + y2) / 2 + dx / length * bend];
    const [a, b] = [border(from, mx - x1, my - y1), border(to, mx - x2, my - y2)];
    return `M${a[0]} ${a[1]}Q${mx.toFixed(1)} ${my.toFixed(1)} ${b[0]} ${b[1]}`;
  }
  function border({ place: [x, y], size: [w, h] }, dx, dy) {
    const share2 = Math.min(w / 2 / Math.abs(dx || 1e-9), h / 2 / Math.abs(dy || 1e-9), 1);
    return [(x + dx * share2).toFixed(1), (y + dy * share2).toFixed(1)];
  }
  function around2(motifs2) {
    const low = [0, 1].map((k) => Math.min(...motifs2.map(({ place: place5, size }) => place5[k] - size[k] / 2)) - AIR);
    const high = [0, 1].map((k) => Math.max(...motifs2.map(({ place: place5, size }) => place5[k] + size[k] / 2)) + AIR);
    return [low[0], low[1], high[0] - low[0], high[1] - low[1]];
  }

  // motifs/matrix_block.mjs
  function drawMatrix(place5, { motifs: motifs2, cells }, context) {
    const n = motifs2.length;
    if (!n) {
      place5.append(element("p", "muted", "No movement recurs with these settings."));
      return {};
    }
    const most = Math.max(...cells.map(([, , count]) => count), 1);
    const svg = svgElement("svg", { class: "block-matrix", viewBox: `-3 -3 ${n + 3.5} ${n + 3.5}`, role: "group", "aria-label": "What follows what" });
    svg.append(svgElement("rect", { x: 0, y: 0, width: n, height: n, class: "block-ground" }));
    const bars = motifs2.flatMap((_, k) => [
      svgElement("rect", { x: 0, y: k, width: n, height: 1, class: "block-line" }),
      svgElement("rect", { x: k, y: 0, width: 1, height: n, class: "block-line" })
    ]);
    svg.append(...bars);
    const squares = [];
    const heads = motifs2.map(() => []);
    for (const [row7, column, count] of cells) {
      const cell2 = svgElement("rect", { x: column + 0.06, y: row7 + 0.06, width: 0.88, height: 0.88, class: "block-cell", "fill-opacity": 0.25 + 0.75 * Math.sqrt(count / most) });
      tipOn(cell2, () => [`${motifs2[row7].name} to ${motifs2[column].name}`, `${count} times`]);
      cell2.addEventListener("click", () => context.select({ edge: `${motifs2[row7].id}-${motifs2[column].id}` }));
      squares.push(cell2);
      svg.append(cell2);
    }
    motifs2.forEach((motif, k) => {
      for (const across of [false, true]) {
        const at3 = across ? { x: k + 0.5, y: -0.35, "text-anchor": "middle" } : { x: -0.35, y: k + 0.72, "text-anchor": "end" };
        const name = svgElement("text", { ...at3, class: "block-head", style: `fill: ${motif.colour}` }, String(motif.id));
        tipOn(name, () => [motif.name]);
        heads[k].push(name);
        svg.append(across ? name : asButton(name, motif.name, () => choose(context, motif)));
        if (across) name.addEventListener("click", () => choose(context, motif));
      }
    });
    place5.append(svg);
    return {
      motion: (selection) => motionOf(selection, motifs2),
      narrow(label, among2) {
        const fit2 = motifs2.map((motif) => fits(motif, label, among2));
        heads.forEach((names2, k) => names2.forEach((name) => name.classList.toggle("faint", !fit2[k])));
        cells.forEach(([row7, column], k) => squares[k].classList.toggle("faint", !(fit2[row7] && fit2[column])));
      },
      light(selection, motion) {
        const chosen3 = motifsToLight(selection, motion, motifs2);
        cells.forEach(([row7, column], k) => squares[k].classList.toggle("chosen", selection.edge === `${motifs2[row7].id}-${motifs2[column].id}`));
        motifs2.forEach((motif, k) => {
          bars[2 * k].classList.toggle("chosen", chosen3.has(motif.id));
          bars[2 * k + 1].classList.toggle("chosen", chosen3.has(motif.id));
        });
      }
    };
  }

  // search/hits_block.mjs
  function drawHits(place5, { query: query2, hits }, context) {
    const rows2 = hits.map(({ clip, start: start3, end, seconds, score, label, strip }) => tableRow(
      [clip, seconds.toFixed(1), score.toFixed(2), `${start3} to ${end}`, label],
      strip,
      `Play ${clip}, frames ${start3} to ${end}`,
      () => context.select({ clip, start: start3, end }, { title: `${clip}, ${start3} to ${end}`, items: [{ clip, start: start3, end, label: clip }] })
    ));
    place5.append(element("p", "muted", `Like ${query2}`), tableOf(["Clip", "Seconds", "Score", "Frames", "Mostly", "Motion"], rows2, hits.length ? "" : "Nothing is like it."));
    return {
      light: (_selection, motion) => hits.forEach(({ clip, start: start3, end }, k) => rows2[k].classList.toggle("chosen", isIn([clip, start3, end], motion))),
      narrow: (label, among2) => hits.forEach((hit, k) => rows2[k].classList.toggle("faint", isFaint(among2, hit.clip) || Boolean(label) && !isMostly(hit.label, label)))
    };
  }

  // sweeps/sweep_block.mjs
  var SERIES = ["#3b6abf", "#d2762b", "#3a9b7a", "#a45fc0", "#c2486a", "#7f8a2e", "#2f95b0", "#8c6d53"];
  var [WIDTH2, HEIGHT2, LEFT, RIGHT, TOP, BOTTOM] = [640, 300, 52, 12, 12, 44];
  function drawSweep(place5, content) {
    const picker = element("select", "block-select", ...content.measures.map(([key, name]) => {
      const option2 = element("option", "", name);
      option2.value = key;
      return option2;
    }));
    picker.setAttribute("aria-label", "What the chart shows");
    const chart2 = element("div", "block-chart");
    let view4 = {};
    const show6 = () => chart2.replaceChildren(lines(content, picker.value, view4));
    picker.addEventListener("change", show6);
    show6();
    place5.append(element("div", "block-chart-head", picker, content.series.length > 1 ? legend3(content.series) : null), chart2);
    return {
      settle(now6) {
        const other = (content.keys ?? []).some((key) => (now6[key] ?? "") !== (view4[key] ?? ""));
        view4 = now6;
        if (other) show6();
      }
    };
  }
  function isAt({ keys = [], settings }, series, k, view4) {
    const own2 = settings?.[series]?.[k];
    return own2 !== void 0 && keys.every((key) => (own2[key] ?? "") === (view4[key] ?? ""));
  }
  function legend3(series) {
    return element("span", "block-legend", ...series.map((name, k) => {
      const key = element("span", "block-key", name);
      key.style.setProperty("--colour", SERIES[k % SERIES.length]);
      return key;
    }));
  }
  function lines(content, measure2, view4) {
    const { x, series, measures, figures } = content;
    const [, name, unit2, digits] = measures.find(([key]) => key === measure2) ?? measures[0];
    const rows2 = figures[measure2];
    const values = rows2.flat().flatMap((cell2) => cell2 ?? []);
    const [low, high] = range(Math.min(...values), Math.max(...values));
    const n = x.values.length;
    const across = (k) => LEFT + (k + 0.5) / n * (WIDTH2 - LEFT - RIGHT);
    const up = (value) => HEIGHT2 - BOTTOM - (value - low) / (high - low) * (HEIGHT2 - TOP - BOTTOM);
    const svg = svgElement("svg", { viewBox: `0 0 ${WIDTH2} ${HEIGHT2}`, class: "block-lines", role: "img", "aria-label": `${name} over ${x.name}` });
    for (const value of ticks(low, high)) {
      svg.append(
        svgElement("path", { d: `M${LEFT} ${up(value)}H${WIDTH2 - RIGHT}`, class: "block-grid" }),
        svgElement("text", { x: LEFT - 6, y: up(value) + 4, "text-anchor": "end" }, String(Number(value.toPrecision(6))))
      );
    }
    x.values.forEach((value, k) => svg.append(svgElement("text", { x: across(k), y: HEIGHT2 - BOTTOM + 17, "text-anchor": "middle" }, value)));
    svg.append(svgElement("text", { x: (LEFT + WIDTH2 - RIGHT) / 2, y: HEIGHT2 - 6, "text-anchor": "middle" }, x.name));
    rows2.forEach((row7, s) => {
      const colour = SERIES[s % SERIES.length];
      const there = row7.flatMap((cell2, k) => cell2 ? [[k, cell2[0]]] : []);
      svg.append(svgElement("path", { d: there.map(([k, value], i) => `${i ? "L" : "M"}${across(k)} ${up(value)}`).join(""), stroke: colour, class: "block-line-of" }));
      row7.forEach((cell2, k) => {
        if (!cell2) return;
        svg.append(svgElement("path", { d: `M${across(k)} ${up(cell2[1])}V${up(cell2[2])}`, stroke: colour, class: "block-spread" }));
        const dot3 = svgElement("circle", { cx: across(k), cy: up(cell2[0]), r: 4.5, fill: colour, tabindex: 0 });
        const here3 = isAt(content, s, k, view4);
        if (here3) svg.append(svgElement("circle", { cx: across(k), cy: up(cell2[0]), r: 9, class: "block-here" }));
        const words4 = cell2.map((value) => value.toFixed(digits));
        tipOn(dot3, () => [`${name}: ${words4[0]}${unit2 && ` ${unit2}`}`, `${x.name} ${x.values[k]}${series[s] && `, ${series[s]}`}`, words4[1] === words4[2] ? "" : `${words4[1]} to ${words4[2]} over the seeds`, here3 ? "The settings of this page" : ""]);
        svg.append(dot3);
      });
    });
    return svg;
  }
  function range(low, high) {
    const air = 0.08 * (high - low) || Math.abs(high) * 0.1 || 1;
    return [low >= 0 ? Math.max(0, low - air) : low - air, high + air];
  }
  function ticks(low, high) {
    const rough = (high - low) / 5;
    const power = 10 ** Math.floor(Math.log10(rough));
    const step3 = ([1, 2, 5, 10].find((k) => k * power >= rough) ?? 10) * power;
    const first = Math.ceil(low / step3);
    return Array.from({ length: Math.floor(high / step3) - first + 1 }, (_, k) => (first + k) * step3);
  }

  // report/blocks.mjs
  offer({
    overview: drawOverview,
    tracks: drawTracks,
    graph: drawGraph,
    motifs: drawMotifs,
    matrix: drawMatrix,
    numbers: drawNumbers,
    map: drawMap,
    actions: drawActions,
    sweep: drawSweep,
    hits: drawHits,
    text: drawText,
    stage: drawStage,
    view: drawView
  });

  // groups/charts.mjs
  var MEASURES = { share: "share of time", rate: "how often", duration: "how long", mean: "", probability: "" };
  var [WIDTH3, HEIGHT3] = [340, 150];
  var [LEFT2, RIGHT2, TOP2, BOTTOM2] = [40, 8, 8, 22];
  var COLOURS2 = ["var(--group-a)", "var(--group-b)"];
  var nameOf = (row7) => [row7.name, MEASURES[
    /** @type {keyof typeof MEASURES} */
    row7.measure
  ]].filter(Boolean).join(", ");
  var figure = (value) => value === null || value === void 0 ? "" : Math.abs(value) > 1e8 ? "∞" : Math.abs(value) >= 100 ? value.toFixed(0) : Math.abs(value) >= 10 ? value.toFixed(1) : value.toFixed(2);
  var chance = (p) => p === null ? "" : p < 1e-3 ? "< .001" : p.toFixed(3).replace(/^0/, "");
  var factsOf2 = (row7) => [
    nameOf(row7),
    `${row7.groups[0]}: ${figure(row7.means[0])} ${row7.unit} (${row7.n[0]})`,
    `${row7.groups[1]}: ${figure(row7.means[1])} ${row7.unit} (${row7.n[1]})`,
    `difference ${figure(row7.difference)}, 95 % from ${figure(row7.interval[0])} to ${figure(row7.interval[1])}`,
    `effect ${figure(row7.effect)}, p ${chance(row7.p)}, corrected ${chance(row7.q)}`
  ];
  function effectChart(rows2, play8) {
    const most = Math.max(1, ...rows2.map((row7) => Math.min(Math.abs(row7.effect ?? 0), 4)));
    const lines2 = rows2.map((row7) => {
      const share2 = Math.min(Math.abs(row7.effect ?? 0), 4) / most;
      const bar = element("span", "groups-bar");
      bar.style.setProperty("--share", String(share2));
      bar.dataset.side = (row7.effect ?? 0) < 0 ? "less" : "more";
      const line3 = element(
        "tr",
        row7.significant ? "" : "faint",
        element("td", "groups-name", nameOf(row7)),
        element("td", "groups-effect", bar),
        element("td", "number", figure(row7.effect)),
        element("td", "number", `${figure(row7.means[0])} → ${figure(row7.means[1])} ${row7.unit}`),
        element("td", "number", chance(row7.q))
      );
      tipOn(line3, () => factsOf2(row7));
      return row7.examples ? asButton(line3, `Play examples: ${nameOf(row7)}`, () => play8(row7)) : line3;
    });
    const heads = ["What", "Effect", "", "Means", "Corrected p"].map((head3, k) => element("th", k > 1 ? "number" : "", head3));
    return element("div", "groups-table", element("table", "", element("thead", "", element("tr", "", ...heads)), element("tbody", "", ...lines2)));
  }
  function transitionMatrix(rows2, play8) {
    const ids = [...new Set(rows2.flatMap((row7) => row7.id.split(">")))].sort((a, b) => a.localeCompare(b, void 0, { numeric: true }));
    const names2 = namesOf(rows2);
    const at3 = new Map(ids.map((id, k) => [id, k]));
    const size = 14;
    const svg = svgElement("svg", { class: "groups-matrix", viewBox: `-26 -26 ${ids.length * size + 28} ${ids.length * size + 28}`, role: "img", "aria-label": "Differences of what follows what" });
    for (const row7 of rows2) {
      const [source, target2] = row7.id.split(">").map((id) => (
        /** @type {number} */
        at3.get(id)
      ));
      const cell2 = svgElement("rect", { x: target2 * size, y: source * size, width: size - 1, height: size - 1, rx: 2, class: `groups-cell${row7.significant ? " certain" : ""}` });
      cell2.style.fill = (row7.difference ?? 0) < 0 ? COLOURS2[0] : COLOURS2[1];
      cell2.style.fillOpacity = String(Math.min(1, 0.06 + Math.abs(row7.difference ?? 0)));
      tipOn(cell2, () => factsOf2(row7));
      if (row7.examples) asButton(cell2, `Play examples: ${row7.name}`, () => play8(row7));
      svg.append(cell2);
    }
    const step3 = Math.ceil(ids.length / 24);
    ids.forEach((id, k) => {
      if (k % step3) return;
      for (
        const [x, y, anchor] of
        /** @type {[number, number, string][]} */
        [[-4, k * size + 10, "end"], [k * size + 6, -5, "middle"]]
      ) {
        const text = svgElement("text", { x, y, "text-anchor": anchor, class: "groups-tick" });
        text.textContent = id.slice(0, 4);
        tipOn(text, () => [names2.get(id) ?? id]);
        svg.append(text);
      }
    });
    return svg;
  }
  function differenceGraph(rows2, play8) {
    const strong = rows2.filter((row7) => Math.abs(row7.difference ?? 0) >= 0.1).sort((a, b) => Number(b.significant) - Number(a.significant) || Math.abs(b.difference ?? 0) - Math.abs(a.difference ?? 0)).slice(0, 60);
    const ids = [...new Set(strong.flatMap((row7) => row7.id.split(">")))];
    const names2 = namesOf(rows2);
    const radius = 150;
    const place5 = new Map(ids.map((id, k) => [id, [radius * Math.sin(2 * Math.PI * k / ids.length), -radius * Math.cos(2 * Math.PI * k / ids.length)]]));
    const svg = svgElement("svg", { class: "groups-graph", viewBox: "-190 -180 380 360", role: "img", "aria-label": "Difference graph" });
    for (const row7 of strong) {
      const [[x, y], [u, v]] = row7.id.split(">").map((id) => (
        /** @type {number[]} */
        place5.get(id)
      ));
      const bend = 0.18;
      const path2 = x === u && y === v ? `M${x} ${y} c${x * 0.25 - y * 0.12} ${y * 0.25 + x * 0.12} ${x * 0.25 + y * 0.12} ${y * 0.25 - x * 0.12} 0 0` : `M${x} ${y} Q${(x + u) / 2 - (v - y) * bend} ${(y + v) / 2 + (u - x) * bend} ${u} ${v}`;
      const line3 = svgElement("path", { d: path2, class: `groups-way${row7.significant ? " certain" : ""}` });
      line3.style.stroke = (row7.difference ?? 0) < 0 ? COLOURS2[0] : COLOURS2[1];
      line3.style.strokeWidth = String(1 + 7 * Math.abs(row7.difference ?? 0));
      tipOn(line3, () => factsOf2(row7));
      if (row7.examples) asButton(line3, `Play examples: ${row7.name}`, () => play8(row7));
      svg.append(line3);
    }
    for (const [id, [x, y]] of place5) {
      const node = svgElement("g", { transform: `translate(${x} ${y})` }, svgElement("circle", { r: 13, class: "groups-node" }));
      const text = svgElement("text", { "text-anchor": "middle", y: 4, class: "groups-tick" });
      text.textContent = id.slice(0, 4);
      node.append(text);
      tipOn(node, () => [names2.get(id) ?? id]);
      svg.append(node);
    }
    return svg;
  }
  function namesOf(rows2) {
    const names2 = /* @__PURE__ */ new Map();
    for (const row7 of rows2) {
      const [source, target2] = row7.id.split(">");
      const [a, ...b] = row7.name.split(" to ");
      if (b.length === 1) names2.set(source, a).set(target2, b[0]);
    }
    return names2;
  }
  function mapChart({ groups, grid: [across, down], difference, clusters }) {
    const size = 10;
    const most = Math.max(1e-9, ...difference.map(Math.abs));
    const svg = svgElement("svg", { class: "groups-map", viewBox: `0 0 ${across * size} ${down * size}`, role: "img", "aria-label": "Differences on the motion map" });
    const certain = new Map(clusters.flatMap(({ nodes, p }) => nodes.map(([i, j]) => [i * down + j, p])));
    difference.forEach((value, k) => {
      const [i, j] = [Math.floor(k / down), k % down];
      const cell2 = svgElement("rect", { x: i * size, y: j * size, width: size, height: size, class: `groups-cell${certain.has(k) ? " certain" : ""}` });
      cell2.style.fill = value < 0 ? COLOURS2[0] : COLOURS2[1];
      cell2.style.fillOpacity = String(Math.abs(value) / most);
      tipOn(cell2, () => [`${value > 0 ? groups[1] : groups[0]} is here ${figure(Math.abs(value))} % of the time more`, ...certain.has(k) ? [`p ${chance(certain.get(k) ?? null)} over the whole map`] : []]);
      svg.append(cell2);
    });
    return svg;
  }
  function curveChart({ curve, unit: unit2, groups, n, means, spreads, clusters, q }) {
    const all = means.flatMap((mean, g) => mean.flatMap((value, k) => [value - spreads[g][k], value + spreads[g][k]]));
    const [low, high] = [Math.min(...all), Math.max(...all)];
    const x = (share2) => LEFT2 + share2 / 100 * (WIDTH3 - LEFT2 - RIGHT2);
    const y = (value) => TOP2 + (high - value) / (high - low || 1) * (HEIGHT3 - TOP2 - BOTTOM2);
    const svg = svgElement("svg", { class: "groups-curve", viewBox: `0 0 ${WIDTH3} ${HEIGHT3}`, role: "img", "aria-label": `${curve} of ${groups.join(" and ")}` });
    for (const { start: start3, end, p } of clusters) {
      const mark3 = svgElement("rect", { x: x(start3), y: TOP2, width: Math.max(x(end) - x(start3), 1.5), height: HEIGHT3 - TOP2 - BOTTOM2, class: "groups-cluster" });
      tipOn(mark3, () => [`${start3.toFixed(0)} to ${end.toFixed(0)} %: p ${chance(p)}`]);
      svg.append(mark3);
    }
    means.forEach((mean, g) => {
      const above = mean.map((value, k) => `${x(k)},${y(value + spreads[g][k])}`);
      const below = mean.map((value, k) => `${x(k)},${y(value - spreads[g][k])}`).reverse();
      const band2 = svgElement("polygon", { points: [...above, ...below].join(" "), class: "groups-band" });
      const line3 = svgElement("polyline", { points: mean.map((value, k) => `${x(k)},${y(value)}`).join(" "), class: "groups-mean" });
      band2.style.fill = line3.style.stroke = COLOURS2[g];
      svg.append(band2, line3);
    });
    for (
      const [px, py, words4, anchor] of
      /** @type {[number, number, string, string][]} */
      [
        [LEFT2 - 4, TOP2 + 9, `${figure(high)}`, "end"],
        [LEFT2 - 4, HEIGHT3 - BOTTOM2, `${figure(low)}`, "end"],
        [LEFT2, HEIGHT3 - 7, "0 %", "start"],
        [WIDTH3 - RIGHT2, HEIGHT3 - 7, "100 %", "end"]
      ]
    ) {
      const text = svgElement("text", { x: px, y: py, "text-anchor": anchor, class: "groups-tick" });
      text.textContent = words4;
      svg.append(text);
    }
    return element("figure", "groups-figure", svg, element("figcaption", "", `${curve} (${unit2}), `, element("span", "muted", `${n[0]} and ${n[1]}, corrected p ${chance(q)}`)));
  }

  // groups/ids.mjs
  var GROUPS_PLACE = "groups-place";

  // groups/groups.mjs
  var POLL3 = 700;
  var SHOWN = 24;
  var PARTS = (
    /** @type {[string, string][]} */
    [["figure", "Gait and posture"], ["label", "Labels"], ["motif", "Motifs"], ["action", "Actions"], ["routine", "Routines"]]
  );
  var shown4 = { dataset: "", view: {}, mark: "", choices: null, place: null };
  var timer2 = 0;
  register("groups", {
    /** @param {View | null} view @param {string | null} dataset @param {string | null} ended */
    show(view4, dataset2, ended) {
      const place5 = find(GROUPS_PLACE);
      if (!place5) return clientside.no_update;
      const mark3 = JSON.stringify([dataset2, view4, ended]);
      if (place5 === shown4.place && mark3 === shown4.mark) return clientside.no_update;
      const other = place5 !== shown4.place || dataset2 !== shown4.dataset;
      Object.assign(shown4, { dataset: dataset2 ?? "", view: { ...view4 }, mark: mark3, place: place5 });
      draw2(place5, other).catch((error) => place5.replaceChildren(element("p", "form-problem", error.message)));
      return clientside.no_update;
    }
  });
  async function draw2(place5, other) {
    clearTimeout(timer2);
    const { mark: mark3, dataset: dataset2 } = shown4;
    if (!dataset2) {
      place5.replaceChildren(element("p", "muted", "Choose a dataset first."));
      return;
    }
    if (other || !shown4.choices) shown4.choices = await ask2(`groups/${encodeURIComponent(dataset2)}`);
    if (mark3 !== shown4.mark) return;
    const choices2 = (
      /** @type {Choices} */
      shown4.choices
    );
    if (!choices2.columns.length) {
      place5.replaceChildren(nothingKnown(dataset2));
      return;
    }
    const result = element("div", "groups-result");
    place5.replaceChildren(form(choices2), result);
    const { by, first, second } = shown4.view;
    if (by && Boolean(first) === Boolean(second)) await look(result, mark3);
    else if (by) result.append(element("p", "muted", "Choose the other group as well, or all for both."));
    else result.append(element("p", "muted", "Choose the property that makes the groups, such as condition or session."));
  }
  var nothingKnown = (dataset2) => element(
    "div",
    "empty-state",
    element("h2", "", "Nothing is known of the clips yet"),
    element("p", "muted", "Groups are made of properties of clips: who moves, in which condition, in which session. They come from a table, from the names of the clips, or by hand."),
    withAttributes(button("Properties of clips", () => void 0, "primary for-editors"), { "data-properties": dataset2 })
  );
  function form(choices2) {
    const { view: view4 } = shown4;
    const column = choices2.columns.find(({ name }) => name === view4.by);
    const values = (
      /** @type {[string, string][]} */
      (column?.values ?? []).map(([value, count]) => [value, `${value} (${count})`])
    );
    const others = (
      /** @type {[string, string][]} */
      choices2.columns.filter(({ name }) => name !== view4.by).map(({ name }) => [name, name])
    );
    return element(
      "div",
      "card groups-form",
      pick("Groups by", "by", [["", "choose ..."], .../** @type {[string, string][]} */
      choices2.columns.map(({ name }) => [name, name])], { first: "", second: "" }),
      pick("First group", "first", [["", "all"], ...values]),
      pick("Second group", "second", [["", "all"], ...values]),
      pick("Who moves", "who", [["", choices2.who && choices2.who !== view4.by ? choices2.who : "found by name"], ...others, ["-", "not known: clips"]]),
      pick("Counted", "counted", [["", choices2.labels ? "labels" : "motifs"], ["motifs", "motifs"], ["grammar", "actions"], ...choices2.labels ? (
        /** @type {[string, string][]} */
        [["labels", "labels"]]
      ) : []]),
      pick("Paired", "paired", [["", "found by itself"], ["yes", "yes"], ["no", "no"]])
    );
  }
  function pick(label, key, choices2, also = {}) {
    const now6 = shown4.view[key] ?? "";
    const offered2 = choices2.some(([value]) => value === now6) ? choices2 : [
      ...choices2,
      /** @type {[string, string]} */
      [now6, `${now6} (gone)`]
    ];
    const control = element("select", "boards-select", ...offered2.map(([value, words4]) => withAttributes(element("option", "", words4), { value })));
    control.value = now6;
    control.addEventListener("change", () => changeView({ ...also, [key]: control.value }));
    return element("label", "groups-field", element("span", "muted", label), control);
  }
  var query = () => new URLSearchParams(Object.entries(shown4.view).filter(([, value]) => value)).toString();
  var address2 = () => `groups/${encodeURIComponent(shown4.dataset)}`;
  async function look(result, mark3) {
    let answer2;
    try {
      answer2 = await ask2(`${address2()}/comparison?${query()}`);
    } catch (error2) {
      answer2 = { state: "failed", error: error2 instanceof Error ? error2.message : String(error2) };
    }
    if (mark3 !== shown4.mark || !result.isConnected) return;
    const { state: state3, document: made, stage: stage2 = "", fraction = 0, error = "" } = answer2;
    if (state3 === "ready" && made) {
      result.replaceChildren(...drawResult(made));
      return;
    }
    const begin3 = button("Compare", async () => {
      await ask2(`${address2()}/comparison`, Object.fromEntries(Object.entries(shown4.view))).catch((problem2) => result.prepend(element("p", "form-problem", problem2.message)));
      look(result, mark3);
    }, "primary for-editors");
    if (state3 === "running") {
      const bar = element("progress", "boards-progress");
      bar.value = fraction;
      result.replaceChildren(element("p", "muted", `${stage2}, ${percent(fraction)}`), bar);
      timer2 = window.setTimeout(() => look(result, mark3), POLL3);
    } else if (state3 === "refused") result.replaceChildren(withAttributes(element("p", "groups-refused", error), { role: "alert" }));
    else if (state3 === "failed") result.replaceChildren(withAttributes(element("p", "form-problem", error), { role: "alert" }), begin3);
    else result.replaceChildren(element("p", "muted", "This comparison has not been made yet."), begin3);
  }
  function* drawResult(made) {
    const { unit: unit2 } = made;
    const rows2 = made.comparisons;
    const found = (one) => rows2.find((row7) => row7.kind === one.kind && row7.id === one.id && row7.measure === one.measure && (!row7.words || one.text.toLowerCase().startsWith(row7.groups[1].toLowerCase())));
    yield element(
      "section",
      "card groups-answer",
      element("h2", "", "In words"),
      element("p", "groups-who", ...made.groups.map((group, k) => withAttributes(element("span", "groups-group", `${group.name}: ${plural(group.units, unit2)}, ${group.minutes.toFixed(1)} min`), { "data-group": String(Math.min(k, 2)) }))),
      element("ul", "groups-words", ...made.words.map((one) => {
        const row7 = found(one);
        return element("li", "", row7?.examples ? button(one.text, () => play2(row7), "groups-sentence") : one.text);
      })),
      ...made.remarks.map((remark) => element("p", "muted", remark)),
      element("p", "muted", `Test: ${made.test}, two-sided. Corrected: ${made.correction}. Effect: ${made.effect}. A click plays typical and extreme motion of both groups in step.`),
      element("p", "groups-files", ...[["csv", "Table (CSV)"], ["json", "Result (JSON)"], ["py", "Python"], ["sh", "Command"]].map(([kind, words4]) => withAttributes(element("a", "boards-button", words4), { href: `/api/${address2()}/${kind}.file?${query()}`, download: "" })))
    );
    const pairs = [...new Set(rows2.map((row7) => row7.groups.join(" → ")))];
    for (const pair of pairs) {
      const own2 = rows2.filter((row7) => row7.groups.join(" → ") === pair);
      for (const [kind, title] of PARTS) {
        const some = own2.filter((row7) => row7.kind === kind && row7.effect !== null).sort((a, b) => Number(b.significant) - Number(a.significant) || Math.abs(b.effect ?? 0) - Math.abs(a.effect ?? 0));
        if (some.length) yield chartOf(`${title}, ${pair}`, some);
      }
      const ways = made.transitions.filter((row7) => row7.groups.join(" → ") === pair && row7.difference !== null);
      if (ways.length) yield element("section", "card", element("h2", "", `What follows what, ${pair}`), element("p", "muted", "The stronger the colour, the larger the difference of the probability; outlined where it is beyond chance. Arrows: differences of at least 10 %."), element("div", "groups-pair", differenceGraph(ways, play2), transitionMatrix(ways, play2)));
      const place5 = (made.map ?? []).find((one) => one.groups.join(" → ") === pair);
      if (place5) yield element("section", "card", element("h2", "", `Postures on the motion map, ${pair}`), element("p", "muted", place5.clusters.length ? "Coloured by who is there more often; outlined where that is beyond chance." : "Coloured by who is there more often; nowhere beyond chance."), mapChart(place5));
      const curves = made.curves.filter((curve) => curve.groups.join(" → ") === pair).sort((a, b) => a.q - b.q);
      if (curves.length) yield curvesOf(pair, curves);
    }
  }
  function chartOf(title, rows2) {
    const section2 = element("section", "card", element("h2", "", title), effectChart(rows2.slice(0, SHOWN), play2));
    if (rows2.length > SHOWN) {
      const more2 = button(`All ${rows2.length}`, () => section2.replaceChildren(element("h2", "", title), effectChart(rows2, play2)));
      section2.append(more2);
    }
    return section2;
  }
  function curvesOf(pair, curves) {
    const items = [...new Set(curves.map(({ item }) => item))];
    const charts = element("div", "groups-curves");
    const choice2 = element("select", "boards-select", ...items.map((item) => withAttributes(element("option", "", /^\d+$/.test(item) ? `motif ${item}` : item), { value: item })));
    choice2.setAttribute("aria-label", "Movement");
    const fill = () => charts.replaceChildren(...curves.filter(({ item }) => item === choice2.value).map(curveChart));
    choice2.addEventListener("change", fill);
    fill();
    return element("section", "card", element("h2", "", `Curves, ${pair}`), element("p", "muted", "Mean and standard deviation over subjects, from the beginning of the movement to its end; shaded where the curves differ beyond chance."), choice2, charts);
  }
  function play2(row7) {
    const pieces = row7.groups.flatMap((group) => (
      /** @type {["typical", "extreme"]} */
      ["typical", "extreme"].map((kind) => ({ group, kind, piece: row7.examples?.[group]?.[kind] ?? null }))
    ));
    const items = pieces.filter(({ piece }, k) => piece && pieces.findIndex((one) => String(one.piece) === String(piece)) === k).map(({ group, kind, piece }) => {
      const [clip, start3, end] = (
        /** @type {NonNullable<Piece>} */
        piece
      );
      return { clip, start: start3, end, label: `${group}, ${kind}` };
    });
    if (items.length) player.show({ dataset: shown4.dataset, title: nameOf(row7), items, layout: "side", sync: "start" });
  }

  // library/ids.mjs
  var REPORT_TABLE = "report-table";
  var DROP_ZONE = "drop-zone";
  var UPLOAD_BAR = "upload-bar";
  var UPLOAD_PROGRESS = "upload-progress";
  var UPLOAD_SUMMARY = "upload-summary";
  var UPLOAD_LIST = "upload-list";
  var UPLOAD_NAME = "upload-name";
  var UPLOAD = (
    /** @type {StoreId<Upload>} */
    "upload"
  );
  var UPLOAD_INTO = (
    /** @type {StoreId<UploadInto>} */
    "upload-into"
  );
  var BODY_DRAFT = (
    /** @type {StoreId<BodyDraft>} */
    "body-draft"
  );
  var BODY_FILE = (
    /** @type {StoreId<BodyFile>} */
    "body-file"
  );
  var BODY_FRAME_LABEL = "body-frame-label";
  var BODY_EDITOR = "body-editor";

  // library/body.mjs
  var VIEWS = (
    /** @type {const} */
    ["front", "side"]
  );
  var KINDS = [["", "Find out"], ["human", "A person"], ["partial", "Part of a person"], ["other", "No person: an animal, a prop"]];
  var edited = { rigs: null, posture: null, draft: [], before: [], part: "pelvis" };
  function current2() {
    const number2 = edited.posture?.rig ?? 0;
    const rig = edited.rigs?.rigs[number2];
    return rig ? [rig, edited.draft[number2]] : null;
  }
  var jointOf = (rig, said2, part2) => part2 in said2.joints ? said2.joints[part2] : rig.joints[part2] ?? null;
  var untouched = (rigs) => rigs.rigs.map((rig) => ({ changed: false, joints: { ...rig.suggested, ...rig.said }, body: rig.said_body }));
  function assign(part2, joint) {
    const here3 = current2();
    if (!here3 || !edited.rigs) return;
    const [rig, said2] = here3;
    if (jointOf(rig, said2, part2) === joint) return;
    remember2();
    for (const other of edited.rigs.parts) {
      if (joint !== null && other !== part2 && jointOf(rig, said2, other) === joint) said2.joints[other] = null;
    }
    said2.joints[part2] = joint;
    said2.changed = true;
    tell2();
  }
  var remember2 = () => {
    edited.before.push(structuredClone(edited.draft));
  };
  function tell2() {
    setStore(BODY_DRAFT, { dataset: edited.rigs?.dataset ?? "", rigs: edited.draft });
    draw3();
  }
  var words2 = (part2) => (part2[0].toUpperCase() + part2.slice(1)).replace("_", " ");
  var sideOf = (part2) => part2.includes("_") ? part2.split("_")[0] : "centre";
  function drawing2(rig, said2, places, view4) {
    const svg = svgElement("svg", { viewBox: "0 0 100 150", class: "body-drawing", role: "img", "aria-label": `Skeleton, ${view4}` });
    rig.parents.forEach((parent, j) => {
      if (parent < 0) return;
      const [[x1, y1], [x2, y2]] = [places[parent], places[j]];
      svg.append(svgElement("line", { x1, y1, x2, y2, class: "body-bone" }));
    });
    const partOf = {};
    for (const part2 of edited.rigs?.parts ?? []) {
      const joint = jointOf(rig, said2, part2);
      if (joint !== null) partOf[joint] = part2;
    }
    const rank = (j) => {
      const part2 = partOf[rig.names[j]];
      return part2 === void 0 ? 0 : part2 === edited.part ? 3 : view4 === "side" && sideOf(part2) === "left" ? 2 : 1;
    };
    const order = rig.names.map((_, j) => j).sort((a, b) => rank(a) - rank(b));
    for (const j of order) {
      if (rig.ends[j]) continue;
      const name = rig.names[j];
      const part2 = partOf[name];
      const chosen3 = part2 !== void 0 && part2 === edited.part;
      const looks = `body-joint ${part2 ? `known side-${sideOf(part2)}` : ""} ${chosen3 ? "chosen" : ""}`;
      const spot = svgElement("circle", { cx: places[j][0], cy: places[j][1], r: chosen3 ? 2.8 : part2 ? 2 : 1.3, class: looks, "data-joint": name });
      spot.append(svgElement("title", {}, part2 ? `${name}: ${words2(part2).toLowerCase()}` : name));
      svg.append(spot);
    }
    const caption2 = element("figcaption", "muted", view4 === "front" ? "From the front" : "From its left");
    const figure3 = element("figure", "body-view");
    figure3.append(svg, caption2);
    return figure3;
  }
  function select(options, value, label) {
    const made = element("select", "body-select");
    made.setAttribute("aria-label", label);
    for (const [key, text] of options) {
      const option2 = element("option", "", text);
      option2.value = key;
      made.append(option2);
    }
    made.value = value;
    return made;
  }
  function list(rig, said2) {
    const rows2 = element("div", "body-parts");
    const kind = element("div", "body-part body-kind");
    const is = (KINDS.find(([key]) => key === rig.body) ?? KINDS[3])[1].toLowerCase();
    const found = KINDS.map(([key, text]) => [key, key || rig.said_body ? text : `${text} (${is})`]);
    const kinds2 = select(found, said2.body ?? "", "Kind of body");
    kinds2.dataset.kind = "yes";
    kind.append(element("span", "body-name", "Kind of body"), kinds2);
    rows2.append(kind);
    if (Object.keys(rig.suggested).length && !said2.changed) {
      const take4 = element("button", "body-take", "Take these suggestions");
      take4.type = "button";
      take4.dataset.body = "take";
      rows2.append(take4);
    }
    const joints = rig.names.filter((_, j) => !rig.ends[j]).map((name) => [name, name]);
    for (const part2 of edited.rigs?.parts ?? []) {
      const row7 = element("div", `body-part side-${sideOf(part2)}` + (part2 === edited.part ? " chosen" : ""));
      row7.dataset.part = part2;
      const button5 = element("button", "body-name", words2(part2));
      button5.type = "button";
      button5.setAttribute("aria-pressed", String(part2 === edited.part));
      row7.append(button5, select([["", "none"], ...joints], jointOf(rig, said2, part2) ?? "", words2(part2)));
      rows2.append(row7);
    }
    return rows2;
  }
  function draw3() {
    const box4 = find(BODY_EDITOR);
    const here3 = current2();
    if (!box4 || !here3 || !edited.posture) return;
    const [rig, said2] = here3;
    const posture = edited.posture;
    if (posture.front.length !== rig.names.length) return;
    const label = find(BODY_FRAME_LABEL);
    if (label) label.textContent = posture.frame < 0 ? "Rest pose" : `Frame ${posture.frame} of ${posture.clip}`;
    const scrolled = box4.querySelector(".body-parts")?.scrollTop ?? 0;
    const focused = closest({ target: document.activeElement }, ".body-part[data-part]");
    const drawings2 = element("div", "body-drawings");
    drawings2.append(...VIEWS.map((view4) => drawing2(rig, said2, posture[view4], view4)));
    const rows2 = list(rig, said2);
    box4.replaceChildren(drawings2, rows2);
    rows2.scrollTop = scrolled;
    if (focused) rows2.querySelector(`[data-part="${edited.part}"] select`)?.focus();
  }
  document.addEventListener("click", (event) => {
    if (dragged) return void (dragged = false);
    const joint = closest(event, ".body-joint");
    if (joint) return assign(edited.part, joint.dataset.joint ?? null);
    const action = closest(event, "[data-body]")?.dataset.body;
    if (action === "import") open2();
    if (action === "export") exportAll();
    if (action === "take") {
      const here3 = current2();
      if (here3) {
        remember2();
        here3[1].changed = true;
        tell2();
      }
    }
    if (action === "back") {
      edited.draft = edited.before.pop() ?? edited.draft;
      tell2();
    }
    if (action === "reset" && edited.rigs) {
      remember2();
      edited.draft = untouched(edited.rigs);
      tell2();
    }
  });
  for (const kind of ["focusin", "click"]) {
    document.addEventListener(kind, (event) => {
      const part2 = closest(event, ".body-part[data-part]")?.dataset.part;
      if (!part2 || part2 === edited.part) return;
      edited.part = part2;
      light();
    });
  }
  document.addEventListener("change", (event) => {
    const control = targetOf(event);
    const row7 = closest(event, ".body-part");
    const here3 = current2();
    if (!row7 || !here3) return;
    if (row7.dataset.part) {
      edited.part = row7.dataset.part;
      return assign(edited.part, control.value || null);
    }
    remember2();
    Object.assign(here3[1], { body: control.value || null, changed: true });
    tell2();
  });
  var FAR = 5;
  var NEAR2 = 26;
  var dragged = false;
  function jointNear(x, y) {
    let nearest2 = null;
    let least = NEAR2;
    for (const spot of document.querySelectorAll(".body-drawing circle")) {
      const box4 = spot.getBoundingClientRect();
      const away = Math.hypot(box4.x + box4.width / 2 - x, box4.y + box4.height / 2 - y);
      if (away < least) [nearest2, least] = [spot, away];
    }
    return nearest2;
  }
  function held(event) {
    const here3 = current2();
    const joint = closest(event, ".body-joint.known")?.dataset.joint;
    if (here3 && joint) return edited.rigs?.parts.find((part2) => jointOf(...here3, part2) === joint);
    return closest(event, "button.body-name") ? closest(event, ".body-part[data-part]")?.dataset.part : void 0;
  }
  document.addEventListener("pointerdown", (event) => {
    dragged = false;
    const part2 = event.button ? void 0 : held(event);
    if (part2) drag(part2, event);
  });
  function drag(part2, start3) {
    const label = element("div", "body-dragged", words2(part2));
    let target2 = null;
    const move6 = (event) => {
      if (!label.isConnected) {
        if (Math.hypot(event.x - start3.x, event.y - start3.y) < FAR) return;
        document.body.append(label);
        edited.part = part2;
        light();
      }
      event.preventDefault();
      label.style.transform = `translate(${event.x + 12}px, ${event.y + 12}px)`;
      target2?.classList.remove("target");
      target2 = jointNear(event.x, event.y);
      target2?.classList.add("target");
    };
    const end = (event) => {
      for (
        const [kind, listener] of
        /** @type {const} */
        [["pointermove", move6], ["pointerup", end], ["pointercancel", end]]
      ) {
        document.removeEventListener(
          kind,
          /** @type {EventListener} */
          listener
        );
      }
      dragged = label.isConnected;
      label.remove();
      target2?.classList.remove("target");
      if (dragged && target2 && event.type === "pointerup") assign(part2, target2.getAttribute("data-joint"));
    };
    document.addEventListener("pointermove", move6);
    document.addEventListener("pointerup", end);
    document.addEventListener("pointercancel", end);
  }
  function light() {
    const box4 = find(BODY_EDITOR);
    const here3 = current2();
    if (!box4 || !here3) return;
    const joint = jointOf(...here3, edited.part);
    for (const row7 of box4.querySelectorAll(".body-part[data-part]")) {
      const chosen3 = row7.getAttribute("data-part") === edited.part;
      row7.classList.toggle("chosen", chosen3);
      row7.querySelector("button")?.setAttribute("aria-pressed", String(chosen3));
    }
    for (const spot of box4.querySelectorAll("circle")) {
      const chosen3 = spot.getAttribute("data-joint") === joint;
      spot.classList.toggle("chosen", chosen3);
      spot.setAttribute("r", chosen3 ? "2.8" : spot.classList.contains("known") ? "2" : "1.3");
    }
  }
  function open2() {
    const chooser = document.createElement("input");
    chooser.type = "file";
    chooser.accept = ".json,application/json";
    chooser.onchange = async () => {
      const file = chooser.files?.[0];
      if (file) setStore(BODY_FILE, { text: await file.text(), at: Date.now() });
    };
    chooser.click();
  }
  function exportAll() {
    if (!edited.rigs) return;
    const { format, parts: parts2, rigs, dataset: dataset2 } = edited.rigs;
    const said2 = rigs.map((rig, k) => ({
      rig: rig.names,
      body: edited.draft[k].body,
      joints: Object.fromEntries(parts2.map((part2) => [part2, jointOf(rig, edited.draft[k], part2)]))
    }));
    save(JSON.stringify({ format, rigs: said2 }, null, 1) + "\n", `${dataset2} bodies.json`, "application/json");
  }
  register("body", {
    /** @param {BodyRigs | null} rigs @param {BodyPosture | null} posture */
    show(rigs, posture) {
      if (rigs && rigs !== edited.rigs && JSON.stringify(rigs) !== JSON.stringify(edited.rigs)) {
        edited.rigs = rigs;
        edited.draft = untouched(rigs);
        edited.before = [];
        setStore(BODY_DRAFT, null);
      }
      edited.posture = posture;
      draw3();
      return clientside.no_update;
    },
    /** @param {import("./ids.mjs").BodyFilled | null} filled */
    fill(filled2) {
      if (filled2) remember2();
      filled2?.rigs.forEach((said2, k) => {
        if (said2 && edited.draft[k]) edited.draft[k] = { changed: true, joints: said2.joints, body: said2.body };
      });
      if (filled2) tell2();
      return clientside.no_update;
    }
  });

  // library/clips.mjs
  var WORDS = { ok: "read without remarks", warning: "warnings", error: "not read" };
  var ICONS2 = { ok: "check", warning: "warning", error: "error" };
  cellRenderers.ClipLink = (props) => props.value ? reactElement("a", { className: "clip-link ellipsis", href: props.data.href, tabIndex: -1, "data-clip": props.value, draggable: false }, props.value) : null;
  cellRenderers.Mark = (props) => props.value ? reactElement(
    "span",
    { className: "verdict verdict-mark verdict-" + props.value, role: "img", "aria-label": WORDS[props.value], title: props.data && props.data.messages || WORDS[props.value] },
    reactElement("span", { className: "icon icon-" + ICONS2[props.value], style: { width: 14, height: 14 }, "aria-hidden": "true" })
  ) : null;
  function open3(clip) {
    setStore(SELECTION, { clip });
    openPage("/clip");
  }
  document.addEventListener("click", (event) => {
    const link2 = closest(event, "a.clip-link");
    if (!link2 || event.button || event.metaKey || event.ctrlKey || event.shiftKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    open3(link2.dataset.clip);
  }, true);
  document.addEventListener("keydown", (event) => {
    const cell2 = event.key === "Enter" && closest(event, ".ag-cell[col-id='clip']");
    const link2 = cell2 && allWithin(cell2, "a.clip-link")[0];
    if (!link2) return;
    event.preventDefault();
    event.stopPropagation();
    open3(link2.dataset.clip);
  }, true);
  var USUAL = { tab: "clips", files: "all" };
  var set = {};
  register("library", {
    /** @param {string} tab @param {string} files @param {View | null} view */
    look(tab, files, view4) {
      const change2 = {};
      for (
        const [key, value] of
        /** @type {[ViewKey, string][]} */
        [["tab", tab], ["files", files]]
      ) {
        const wanted2 = value === USUAL[key] ? "" : value || "";
        if (value && value !== set[key] && (view4?.[key] || "") !== wanted2) change2[key] = wanted2;
      }
      set = {};
      if (Object.keys(change2).length) changeView(change2);
      return clientside.no_update;
    },
    /** @param {View | null} view @param {{ value: string }[] | null} choices */
    show(view4, choices2) {
      const wanted2 = { ...USUAL, ...view4 };
      const known4 = (choices2 || []).some((choice2) => choice2.value === wanted2.files);
      set = { tab: wanted2.tab === "report" ? "report" : "clips", files: known4 ? wanted2.files : "all" };
      return [set.tab, set.files];
    },
    /** @param {string | null} shown @param {any[] | null} rows */
    filter(shown9, rows2) {
      if (!rows2) {
        gridApi(REPORT_TABLE).then((api) => api?.purgeInfiniteCache?.());
        return clientside.no_update;
      }
      if (!shown9 || shown9 === "all") return rows2 || [];
      return (rows2 || []).filter((row7) => shown9 === "added" ? row7.added : row7.verdict === shown9);
    }
  });

  // library/properties.mjs
  var SETTLED4 = 300;
  var SHOWN2 = 6;
  var KINDS2 = ["text", "number", "date"];
  document.addEventListener("click", (event) => {
    const { properties } = closest(event, "[data-properties]")?.dataset ?? {};
    if (properties) new Dialog(properties, []).open();
  });
  register("properties", {
    /** @param {ClipsOf | null} chosen */
    open(chosen3) {
      if (chosen3) new Dialog(chosen3.dataset, chosen3.clips ?? []).open();
      return clientside.no_update;
    }
  });
  var Dialog = class {
    /** @param {string} dataset @param {string[]} clips those that were chosen */
    constructor(dataset2, clips) {
      this.dataset = dataset2;
      this.clips = clips;
      this.path = `properties/${encodeURIComponent(dataset2)}`;
      this.columns = element("div", "properties-columns");
      this.preview = element("div", "properties-preview");
      this.preview.setAttribute("aria-live", "polite");
      this.waiting = 0;
      this.first = "";
    }
    async open() {
      const file = withAttributes(element("a", "boards-button", "Save as CSV"), { href: `/api/${this.path}/csv`, download: "" });
      const ways = element("div", "properties-ways for-editors");
      this.dialog = openWindow(
        `Properties of clips of ${this.dataset}`,
        this.columns,
        ways,
        this.preview,
        element("div", "boards-actions", file, button("Close", () => this.dialog?.close()))
      );
      try {
        this.show(await ask2(this.path));
      } catch (error) {
        this.refuse(error);
        return;
      }
      ways.append(this.byHand(), this.fromNames(), this.fromTable());
      ways.querySelector("input, textarea")?.focus();
    }
    /** @param {ClipProperties} known */
    show({ columns, clips, first }) {
      this.first = first;
      const rows2 = columns.map((column) => this.row(column, clips));
      const heads = ["Property", "Kind", "Values", "Missing", ""].map((head3) => element("th", "", head3));
      this.columns.replaceChildren(rows2.length ? element("table", "properties-table", element("thead", "", element("tr", "", ...heads)), element("tbody", "", ...rows2)) : element("p", "muted", `Nothing is known yet of its ${plural(clips, "clip")}: who moves, in which condition, in which session. Groups are compared and boards narrowed by such properties.`));
    }
    /** @param {ColumnOfClips} column @param {number} clips */
    row({ name, kind, values, distinct, missing }, clips) {
      const picker = withAttributes(element("select", "boards-select for-editors", ...KINDS2.map((one) => withAttributes(element("option", "", one), { value: one }))), { "aria-label": `Kind of ${name}` });
      picker.value = kind;
      picker.addEventListener("change", () => this.change({ action: "kind", column: name, kind: picker.value }));
      const some = values.slice(0, SHOWN2).map(([value, count]) => `${value} (${count})`).join(", ");
      const remove = iconButton("trash", `Remove ${name}`, () => this.change({ action: "remove", column: name }));
      remove.classList.add("for-editors");
      return element(
        "tr",
        "",
        element("td", "", name),
        element("td", "", picker),
        element("td", "", distinct > SHOWN2 ? `${some} and ${distinct - SHOWN2} more` : some),
        element("td", "number", missing ? `${missing} of ${clips}` : "none"),
        element("td", "", remove)
      );
    }
    byHand() {
      const [name, value] = [this.input("Property", "subject"), this.input("Value", "Ana")];
      const body2 = () => ({ action: "set", column: name.value, value: value.value, clips: this.clips });
      const form2 = this.way(
        `For ${this.clips.length === 1 ? this.clips[0] : plural(this.clips.length, "chosen clip")}`,
        this.clips.length ? "An empty value takes it away." : "Choose clips in the table of the Library by their boxes, then “Properties”.",
        [name, value],
        body2
      );
      if (!this.clips.length) for (const control of form2.querySelectorAll("input, button")) control.toggleAttribute("disabled", true);
      return form2;
    }
    fromNames() {
      const pattern = this.input("Pattern of the names", "{subject}_{condition}_{take}");
      return this.way("From names of clips", `Names in braces become properties, * is anything. The first name is ${this.first}.`, [pattern], () => ({ action: "names", pattern: pattern.value }));
    }
    fromTable() {
      const table3 = withAttributes(element("textarea"), { rows: 4, placeholder: "clip,subject,condition", "aria-label": "Table as CSV" });
      const file = withAttributes(element("input"), { type: "file", accept: ".csv,.tsv,.txt", "aria-label": "CSV file" });
      file.addEventListener("change", async () => {
        table3.value = await file.files?.[0]?.text() ?? "";
        table3.dispatchEvent(new Event("input", { bubbles: true }));
      });
      return this.way("From a table", "CSV whose column “clip” names the clips; choose a file or paste it.", [file, table3], () => ({ action: "table", table: table3.value }));
    }
    /** @param {string} name @param {string} hint */
    input(name, hint) {
      return withAttributes(element("input"), { placeholder: hint, "aria-label": name });
    }
    /**
     * A way to set properties: what it would do is shown while one types.
     * @param {string} title @param {string} hint @param {HTMLElement[]} controls @param {() => Record<string, any>} body
     */
    way(title, hint, controls, body2) {
      const form2 = element("form", "boards-form properties-way", element("h3", "", title), element("small", "muted", hint), ...controls, element("button", "boards-button primary", "Keep"));
      form2.addEventListener("input", () => {
        clearTimeout(this.waiting);
        this.waiting = window.setTimeout(() => this.change({ ...body2(), preview: true }), SETTLED4);
      });
      form2.addEventListener("submit", (event) => {
        event.preventDefault();
        clearTimeout(this.waiting);
        this.change(body2());
      });
      return form2;
    }
    /** @param {Record<string, any>} body */
    async change(body2) {
      try {
        const made = await ask2(this.path, body2);
        this.show(made);
        this.tell(made, body2.preview);
        if (body2.preview) return;
        say("Properties kept.", async () => {
          this.show(await ask2(this.path, { action: "restore", version: made.before }));
          this.preview.replaceChildren();
        });
      } catch (error) {
        this.refuse(error);
      }
    }
    /** @param {ClipProperties} made @param {boolean} preview */
    tell({ remarks = [], rows: rows2 = [] }, preview) {
      const names2 = rows2.length ? Object.keys(rows2[0]) : [];
      this.preview.replaceChildren(
        element("p", preview ? "properties-draft" : "muted", preview ? "Preview: nothing is kept yet." : "Kept."),
        ...remarks.map((words4) => element("p", "muted", words4)),
        rows2.length ? element(
          "table",
          "properties-table",
          element("thead", "", element("tr", "", ...names2.map((name) => element("th", "", name)))),
          element("tbody", "", ...rows2.map((row7) => element("tr", "", ...names2.map((name) => element("td", "", row7[name] ?? "")))))
        ) : ""
      );
    }
    /** @param {unknown} error */
    refuse(error) {
      const problem2 = element("p", "form-problem", error instanceof Error ? error.message : String(error));
      problem2.setAttribute("role", "alert");
      this.preview.replaceChildren(problem2);
    }
  };

  // library/batch.mjs
  var MOTION = ["FBX", "VMD", "PKL", "BIP", "HTR", "BLEND", "DAE", "USD"];
  var MAYBE = /\.(csv|tsv|txt|json|npy|npz)(\.gz)?$/i;
  var BESIDE2 = /\.(asf|bin|zip)(\.gz)?$/i;
  var sizeInWords = (bytes2) => bytes2 >= 2 ** 30 ? (bytes2 / 2 ** 30).toFixed(1) + " GB" : bytes2 >= 1e5 ? (bytes2 / 2 ** 20).toFixed(1) + " MB" : Math.max(1, Math.round(bytes2 / 1024)) + " kB";
  function freshBatch() {
    return { token: null, items: [], sent: 0, bytes: 0, active: 0, queue: [], stopped: false, name: "", hidden: 0, ignored: {} };
  }
  function freePath(mine2, file, path2) {
    for (let k = 1; ; k++) {
      const tried = k === 1 ? path2 : k + "/" + path2;
      const there = mine2.items.find((item) => item.path === tried && item.state !== "error");
      if (!there) return tried;
      if (there.file.size === file.size && there.file.lastModified === file.lastModified) return null;
    }
  }
  function refuse(item, message2) {
    item.state = "error";
    item.message = message2;
  }
  function kinds(mine2) {
    const count = (pattern) => mine2.items.filter((item) => item.state !== "error" && pattern.test(item.path)).length;
    const archives = count(/\.zip$/i);
    const here3 = mine2.items.filter((item) => item.state !== "error");
    const recordings = here3.filter((item) => MAYBE.test(item.path) ? item.recording : !BESIDE2.test(item.path)).length + archives;
    const labels2 = here3.filter((item) => /\.csv$/i.test(item.path) && !item.recording).length;
    return { recordings, labels: labels2, amc: count(/\.amc(\.gz)?$/i), archives };
  }
  function nameOf2(files) {
    if (!files.length) return "";
    const parts2 = files[0].path.split("/");
    if (parts2.length > 1) return parts2[0];
    return files.length > 1 ? "Recordings" : parts2[0].replace(/(\.[a-z0-9]{1,5})(\.gz)?$/i, "");
  }
  var kindOf2 = (path2) => /\.([a-z0-9]{1,8})$/.exec(path2)?.[1]?.toUpperCase() ?? "other";
  function leftOut(mine2) {
    const counts2 = Object.entries(mine2.ignored).sort((a, b) => b[1] - a[1] || a[0].localeCompare(b[0]));
    const words4 = counts2.map(([kind, count]) => `${count} ${kind}`).join(", ");
    const motion = counts2.some(([kind]) => MOTION.includes(kind));
    return words4 && `${words4} left out${motion ? "; convert motion to BVH, with Blender for example" : ""}`;
  }
  function takeFiles(mine2, files, { fileBytes, totalBytes, files: most, suffixes: suffixes2 }) {
    const isReadable = (path2) => suffixes2.some((suffix) => path2.toLowerCase().endsWith(suffix));
    if (!mine2.name) mine2.name = nameOf2(files.filter(({ path: path2 }) => isReadable(path2) && !/\.csv(\.gz)?$/i.test(path2)));
    const taken = [];
    for (const { file, path: given2 } of files) {
      const path2 = freePath(mine2, file, given2);
      if (!path2) continue;
      const lower = path2.toLowerCase();
      const readable2 = isReadable(path2);
      if (!readable2 && files.length > 1 && !/\.(bvh|amc|asf|zip)/i.test(lower)) {
        const kind = kindOf2(lower);
        mine2.ignored[kind] = (mine2.ignored[kind] ?? 0) + 1;
        continue;
      }
      const item = { file, path: path2, sent: 0, state: "waiting", message: "", row: null };
      mine2.items.push(item);
      taken.push(item);
      if (!readable2) refuse(item, "not a kind of file we read; convert it to BVH");
      else if (file.size > fileBytes) refuse(item, `too large: ${sizeInWords(file.size)}; a file may have ${sizeInWords(fileBytes)}`);
      else if (mine2.queue.length + mine2.sent >= most) refuse(item, `too many files: ${most} at most`);
      else if (mine2.bytes + file.size > totalBytes) refuse(item, `too much altogether: ${sizeInWords(totalBytes)} at most`);
      else {
        mine2.bytes += file.size;
        mine2.queue.push(item);
      }
    }
    return taken;
  }

  // library/upload.mjs
  var HEADERS = { "X-Motionscape": "upload" };
  var AT_ONCE = 3;
  var SHOWN3 = 400;
  var batch = null;
  var limits = () => {
    const data2 = need(DROP_ZONE).dataset;
    return {
      fileBytes: Number(data2.fileBytes),
      totalBytes: Number(data2.totalBytes),
      files: Number(data2.files),
      suffixes: (data2.suffixes ?? "").split(" ")
    };
  };
  async function gather(transfer) {
    const entries = [...transfer.items].filter((item) => item.kind === "file").map((item) => item.webkitGetAsEntry && item.webkitGetAsEntry());
    if (!entries.some(Boolean)) return [...transfer.files].map((file) => ({ file, path: file.name }));
    const files = [];
    for (const entry of entries) if (entry) await walk(entry, "", files);
    return files;
  }
  async function walk(entry, folder, files) {
    if (files.length > 2e4) return;
    if (entry.isFile) {
      const file = await new Promise((resolve) => entry.file(resolve, () => resolve(null)));
      if (file) files.push({ file, path: folder + entry.name });
      return;
    }
    const reader = entry.createReader();
    for (; ; ) {
      const some = await new Promise((resolve) => reader.readEntries(resolve, () => resolve([])));
      if (!some.length) return;
      for (const child of some) await walk(child, folder + entry.name + "/", files);
    }
  }
  async function add(files) {
    if (!files.length) return;
    if (!batch || batch.stopped) batch = freshBatch();
    const mine2 = batch;
    for (const item of takeFiles(mine2, files, limits())) draw4(mine2, item);
    tell3(mine2);
    if (!mine2.token) {
      try {
        const answer2 = await fetch("/api/uploads", { method: "POST", headers: HEADERS });
        if (!answer2.ok) throw new Error();
        mine2.token = (await answer2.json()).token;
      } catch {
        for (const item of mine2.queue.splice(0)) {
          refuse(item, "the server cannot be reached");
          draw4(mine2, item);
        }
        tell3(mine2);
        return;
      }
    }
    while (mine2.active < AT_ONCE && mine2.queue.length) next(mine2);
    tell3(mine2);
  }
  function next(mine2) {
    const item = mine2.queue.shift();
    if (!item || mine2.stopped) return;
    mine2.active += 1;
    item.state = "sending";
    const request5 = new XMLHttpRequest();
    item.request = request5;
    request5.open("PUT", "/api/uploads/" + mine2.token + "/" + item.path.split("/").map(encodeURIComponent).join("/"));
    request5.setRequestHeader("X-Motionscape", "upload");
    request5.setRequestHeader("Content-Type", "application/octet-stream");
    request5.upload.onprogress = (event) => {
      item.sent = event.loaded;
      draw4(mine2, item);
      summary(mine2);
    };
    request5.onloadend = () => {
      mine2.active -= 1;
      if (request5.status === 200) {
        item.state = "ok";
        item.sent = item.file.size;
        mine2.sent += 1;
        try {
          item.recording = JSON.parse(request5.responseText).recording;
        } catch {
        }
      } else {
        let message2 = request5.status ? "the server refused it" : "the connection broke";
        try {
          message2 = JSON.parse(request5.responseText).error || message2;
        } catch {
        }
        refuse(item, message2);
      }
      draw4(mine2, item);
      while (mine2.active < AT_ONCE && mine2.queue.length && !mine2.stopped) next(mine2);
      tell3(mine2);
    };
    request5.send(item.file);
  }
  function draw4(mine2, item) {
    const list3 = find(UPLOAD_LIST);
    if (!list3 || mine2 !== batch) return;
    if (!item.row) {
      if (list3.childElementCount >= SHOWN3 && item.state !== "error") {
        return;
      }
      item.row = document.createElement("li");
      item.row.innerHTML = '<span class="upload-mark"></span><span class="upload-name ellipsis"></span><span class="upload-size number"></span><span class="upload-note"></span>';
      item.row.children[1].textContent = item.path;
      childrenOf(item.row)[1].title = item.path;
      item.row.children[2].textContent = sizeInWords(item.file.size);
      list3.append(item.row);
    }
    item.row.className = "upload-" + item.state;
    const percent3 = item.file.size ? Math.round(100 * item.sent / item.file.size) : 100;
    item.row.style.setProperty("--sent", (item.state === "sending" ? percent3 : 0) + "%");
    item.row.children[3].textContent = { waiting: "waiting", sending: percent3 + " %", ok: "received", error: item.message }[item.state];
  }
  function summary(mine2) {
    const node = find(UPLOAD_SUMMARY);
    if (!node || mine2 !== batch) return;
    const sent2 = mine2.items.reduce((sum2, item) => sum2 + (item.state === "error" ? 0 : item.sent), 0);
    const bad = mine2.items.filter((item) => item.state === "error").length;
    const busy = mine2.active + mine2.queue.length > 0;
    const sentences = [];
    if (mine2.items.length) sentences.push(`${mine2.sent} of ${mine2.items.length - bad} files received, ${sizeInWords(sent2)}`);
    if (bad) sentences.push(`${bad} left out`);
    const ignored = leftOut(mine2);
    if (ignored) sentences.push(ignored);
    node.textContent = sentences.join("; ");
    const bar = find(UPLOAD_BAR);
    if (bar) bar.style.width = (mine2.bytes ? Math.min(100, 100 * sent2 / mine2.bytes) : 0) + "%";
    need(UPLOAD_PROGRESS).classList.toggle("hidden", !busy);
  }
  function tell3(mine2) {
    summary(mine2);
    const done = mine2.active + mine2.queue.length === 0;
    setStore(UPLOAD, { token: mine2.token, received: mine2.sent, done, name: mine2.name, total: mine2.items.length, ...kinds(mine2) });
  }
  function reset(discard) {
    if (batch) {
      batch.stopped = true;
      for (const item of batch.items) if (item.state === "sending") item.request?.abort();
      if (discard && batch.token) fetch("/api/uploads/" + batch.token, { method: "DELETE", headers: HEADERS }).catch(() => {
      });
    }
    batch = null;
    const list3 = find(UPLOAD_LIST);
    if (list3) list3.replaceChildren();
    const node = find(UPLOAD_SUMMARY);
    if (node) node.textContent = "";
  }
  var carriesFiles = (event) => event.dataTransfer && [...event.dataTransfer.types].includes("Files");
  var depth = 0;
  document.addEventListener("dragenter", (event) => {
    if (!carriesFiles(event)) return;
    depth += 1;
    document.documentElement.classList.add("dragging-files");
  });
  document.addEventListener("dragleave", () => {
    depth = Math.max(0, depth - 1);
    if (!depth) document.documentElement.classList.remove("dragging-files");
  });
  document.addEventListener("dragover", (event) => {
    if (carriesFiles(event)) event.preventDefault();
  });
  document.addEventListener("drop", async (event) => {
    depth = 0;
    document.documentElement.classList.remove("dragging-files");
    if (!carriesFiles(event)) return;
    event.preventDefault();
    if (!find(DROP_ZONE)) return;
    const card4 = closest(event, ".dataset-card");
    const files = event.dataTransfer ? await gather(event.dataTransfer) : [];
    if (!find(UPLOAD_LIST) || !need(UPLOAD_LIST).offsetParent) {
      setStore(UPLOAD_INTO, { dataset: card4?.dataset.dataset ?? "", at: Date.now() });
    }
    whenShown(() => add(files));
  });
  document.addEventListener("click", (event) => {
    const button5 = closest(event, "[data-chooses]");
    if (!button5) return;
    const chooser = document.createElement("input");
    chooser.type = "file";
    chooser.multiple = true;
    chooser.webkitdirectory = button5.dataset.chooses === "folder";
    chooser.onchange = () => add([...chooser.files ?? []].map((file) => ({ file, path: file.webkitRelativePath || file.name })));
    chooser.click();
  });
  function whenShown(then, tries = 60) {
    if (find(UPLOAD_LIST)) then();
    else if (tries) setTimeout(() => whenShown(then, tries - 1), 50);
  }
  register("upload", {
    // What is typed meanwhile stays, and nothing comes between the letters of who types.
    /** @param {string | null} suggested @param {string | null} typed */
    name: (suggested, typed) => suggested && document.activeElement?.id === UPLOAD_NAME ? clientside.no_update : suggested && (typed || suggested),
    // The dialog was closed: what was not imported is thrown away. After an import the files belong to the job.
    /** @param {boolean} opened @param {string | null} imported */
    closed(opened, imported) {
      if (opened) return clientside.no_update;
      reset(!(batch && imported && imported === batch.token));
      return { token: null, received: 0, done: true, name: "", total: 0 };
    }
  });

  // clip/ids.mjs
  var CLIP_PREVIOUS = "clip-previous";
  var CLIP_NEXT = "clip-next";
  var CLIP_CHART = "clip-chart";
  var CLIP_KIND = "clip-kind";
  var CLIP_CHANNELS = "clip-channels";
  var CLIP_JOINTS = "clip-joints";
  var CLIP_LEGEND = "clip-legend";
  var CLIP_BOX = "clip-box";
  var CLIP_GRAPH = "clip-graph";
  var CLIP_SEEK = (
    /** @type {StoreId<Moment>} */
    "clip-seek"
  );
  var CLIP_GAIT = "clip-gait";

  // clip/gait.mjs
  var MOST_EVENTS = 600;
  function sends(button5, store, value) {
    button5.type = "button";
    button5.dataset.store = store;
    button5.dataset.value = JSON.stringify(value);
    button5.dataset.stamp = store === "selection" ? "" : "yes";
    return button5;
  }
  function table2(head3, rows2) {
    const made = element("table", "gait-table number");
    const top = made.createTHead().insertRow();
    for (const text of head3) {
      const cell2 = element("th", "", text);
      cell2.scope = "col";
      top.append(cell2);
    }
    const body2 = made.createTBody();
    for (const [name, unit2, ...values] of rows2) {
      const row7 = body2.insertRow();
      const first = element("th", "", name + " ");
      first.scope = "row";
      first.append(element("span", "muted", unit2));
      row7.append(first, ...values.map((value) => element("td", "", value)));
    }
    return made;
  }
  function folding(className, head3, open6, fill) {
    const part2 = element("details", className);
    part2.append(head3);
    part2.addEventListener("toggle", () => {
      if (part2.open && part2.children.length === 1) part2.append(fill());
    });
    part2.open = open6;
    return part2;
  }
  function bout(data2, one, open6) {
    const head3 = element("summary", "gait-head");
    const select3 = sends(element("button", "gait-select", "Select"), "selection", { clip: data2.clip, start: one.start, end: one.end });
    select3.setAttribute("aria-label", `Select the frames of ${one.title}`);
    head3.append(element("b", "", one.title), element("span", "muted number", one.facts));
    return element("div", "gait-row", folding("gait-bout", head3, open6, () => table2(data2.head, one.rows)), select3);
  }
  function events(data2) {
    const list3 = element("div", "gait-events");
    for (const [frame, seconds, side, name] of data2.events.slice(0, MOST_EVENTS)) {
      const row7 = sends(element("button", "gait-event"), CLIP_SEEK, { clip: data2.clip, frame });
      row7.append(
        element("span", "number", seconds),
        element("span", "muted number", `frame ${frame}`),
        element("span", `side-${side}`, side[0].toUpperCase() + side.slice(1)),
        element("span", "", name)
      );
      list3.append(row7);
    }
    const more2 = data2.events.length - MOST_EVENTS;
    if (more2 > 0) list3.append(element("div", "muted", `and ${more2} more: a table of the clip has them all`));
    return list3;
  }
  register("gait", {
    /** @param {Gait | null} data */
    draw(data2) {
      const place5 = find(CLIP_GAIT);
      if (!place5) return clientside.no_update;
      if (!data2) place5.replaceChildren();
      else if (data2.why) place5.replaceChildren(element("div", "muted", data2.why));
      else {
        const all = folding("gait-details", element("summary", "", `${data2.events.length} heel strikes and toe-offs`), false, () => events(data2));
        place5.replaceChildren(...data2.bouts.map((one, k) => bout(data2, one, k === 0)), all);
      }
      return clientside.no_update;
    }
  });

  // clip/cursor.mjs
  var at = { shown: null, frame: null, hover: null, items: [], pending: null, values: null, from: "", range: null, dragged: null };
  var part = (name) => allWithin(document, `#${CLIP_BOX} .clip-${name}`)[0];
  var measured = null;
  var forget = () => {
    measured = null;
  };
  function chartPlot() {
    if (measured && measured.graph.isConnected && at.shown && measured.meta.clip === at.shown.clip) return measured;
    measured = measure();
    return measured;
  }
  function measure() {
    const graph = (
      /** @type {any} */
      document.querySelector(`#${CLIP_GRAPH} .js-plotly-plot`)
    );
    const full = graph && graph._fullLayout;
    if (!full || !full.xaxis || !full.meta || !at.shown || full.meta.clip !== at.shown.clip) return null;
    const box4 = need(CLIP_BOX).getBoundingClientRect();
    const own2 = graph.getBoundingClientRect();
    const { xaxis, yaxis, meta } = full;
    const dx = own2.left - box4.left + xaxis._offset;
    const dy = own2.top - box4.top;
    return {
      graph,
      meta,
      full,
      lines: graph.data.filter((trace) => trace.mode === "lines"),
      chips: allWithin(document, `#${CLIP_LEGEND} .clip-value`),
      left: dx,
      width: xaxis._length,
      top: dy + full._size.t,
      height: full._size.h,
      /** @param {number} value */
      x: (value) => dx + xaxis.l2p(value),
      /** @param {number} value */
      y: (value) => dy + yaxis._offset + yaxis.l2p(value),
      /** @param {number} pixel */
      time: (pixel) => xaxis.p2l(pixel - dx),
      range: xaxis.range.map(Number)
    };
  }
  function placeMarks() {
    const plot = chartPlot();
    const cursor3 = part("cursor");
    if (!cursor3) return;
    const time = plot && plot.meta.kind === "time";
    upright(cursor3, time && at.frame !== null ? at.frame / plot.meta.fps : null, plot);
    upright(part("pointer"), time && at.hover !== null ? at.hover / plot.meta.fps : null, plot);
    band(part("band"), time ? chosenRange() : null, plot);
    dot2(part("dot"), plot && plot.meta.kind === "path" ? at.frame : null, plot);
    if (time) tell4(plot);
  }
  function upright(line3, seconds, plot) {
    const x = seconds === null || !plot ? null : plot.x(seconds);
    line3.hidden = !plot || x === null || x < plot.left - 1 || x > plot.left + plot.width + 1;
    if (line3.hidden || !plot || x === null) return;
    line3.style.height = `${plot.height}px`;
    line3.style.transform = `translate(${x.toFixed(1)}px, ${plot.top}px)`;
  }
  function band(area, range2, plot) {
    area.hidden = !range2;
    if (!range2 || !plot) return;
    const clamp2 = (x) => Math.min(Math.max(x, plot.left), plot.left + plot.width);
    const [a, b] = range2.map((frame) => clamp2(plot.x(frame / plot.meta.fps)));
    Object.assign(area.style, { height: `${plot.height}px`, width: `${Math.max(b - a, 1)}px`, transform: `translate(${a}px, ${plot.top}px)` });
  }
  function dot2(mark3, frame, plot) {
    const path2 = plot && plot.graph.data[0];
    const k = frame === null || !path2 || !path2.customdata ? -1 : nearest(path2.customdata, frame);
    mark3.hidden = k < 0;
    if (plot && k >= 0) mark3.style.transform = `translate(${plot.x(path2.x[k])}px, ${plot.y(path2.y[k])}px)`;
  }
  var chosenRange = () => at.dragged || at.range || null;
  var toldAt = 0;
  var later = 0;
  var DIGITS = { "°": 1, " m/s": 2 };
  function tell4(plot) {
    const now6 = performance.now();
    if (now6 - toldAt < 48) {
      clearTimeout(later);
      later = window.setTimeout(placeMarks, 50);
      return;
    }
    toldAt = now6;
    const frame = at.hover ?? at.frame;
    plot.chips.forEach((chip2, k) => {
      const value = frame === null || !plot.lines[k] ? null : valueAt(plot, plot.lines[k], k, frame);
      const digits = DIGITS[chip2.dataset.unit ?? ""] ?? 3;
      const text = value === null ? "" : value.toFixed(digits).replace("-", "−") + chip2.dataset.unit;
      if (chip2.textContent !== text) chip2.textContent = text;
    });
  }
  function valueAt(plot, line3, k, frame) {
    const { fps, frames, thinned } = plot.meta;
    const whole3 = at.values && at.values.length >= (k + 1) * frames ? at.values[k * frames + Math.min(Math.round(frame), frames - 1)] : null;
    if (thinned) return whole3;
    const i = nearest(line3.x, frame / fps);
    return i < 0 || Math.abs(line3.x[i] - frame / fps) > 1 / fps ? whole3 : line3.y[i];
  }
  var CHART_KEYS = ["chart", "angles", "joints", "rig", "channels"];
  async function fetchValues(view4) {
    if (!at.shown) return;
    const { dataset: dataset2, clip, version } = at.shown;
    const query2 = new URLSearchParams({ v: version });
    for (const key of CHART_KEYS) if (view4?.[key]) query2.set(key, view4[key]);
    const where = clip.split("/").map(encodeURIComponent).join("/");
    const address3 = `/api/clip-values/${encodeURIComponent(dataset2)}/${where}?${query2}`;
    if (address3 === at.from) return;
    at.from = address3;
    at.values = null;
    const answer2 = await fetch(address3).catch(() => null);
    if (!answer2?.ok || at.from !== address3) return;
    const bytes2 = await answer2.arrayBuffer();
    if (at.from !== address3) return;
    at.values = new Float32Array(bytes2);
    placeMarks();
  }
  function seekFrame(frame) {
    const { shown: shown9 } = at;
    if (!shown9) return;
    const wanted2 = Math.min(Math.max(Math.round(frame), 0), shown9.frames - 1);
    const there = at.items.some((item) => isShown(item) && wanted2 >= item.start && wanted2 < item.end);
    if (there && player.seek({ clip: shown9.clip, frame: wanted2 })) return;
    at.pending = { clip: shown9.clip, frame: wanted2 };
    setStore(SELECTION, { clip: shown9.clip });
  }
  function standing2() {
    const items = [];
    for (let k = 0, item; k < 48 && (item = player.frameOf(k)); k++) items.push(item);
    return items;
  }
  var frameNow2 = () => standing2().find(isShown)?.frame ?? at.frame;
  var isShown = (item) => at.shown && item.clip === at.shown.clip && (!item.dataset || item.dataset === at.shown.dataset);
  function follow(items) {
    at.items = items || [];
    const item = at.items.find(isShown);
    if (item && at.pending && at.pending.clip === item.clip && at.pending.frame >= item.start && at.pending.frame < item.end) {
      const { frame } = at.pending;
      at.pending = null;
      player.seek({ clip: item.clip, frame });
    }
    at.frame = item ? item.frame : null;
    placeMarks();
  }
  for (
    const kind of
    /** @type {const} */
    ["stage-frame", "stage-state"]
  ) {
    window.addEventListener(kind, (event) => {
      if (find(CLIP_BOX)) follow(event.detail.items);
    });
  }
  register("clip", {
    // A chart was drawn: lay everything over it again, now and after every redrawing.
    /** @param {any} figure @param {unknown} legend @param {ShownClip | null} shown @param {View | null} view */
    drawn(figure3, legend5, shown9, view4) {
      at.shown = shown9;
      const graph = (
        /** @type {any} */
        document.querySelector(`#${CLIP_GRAPH} .js-plotly-plot`)
      );
      if (graph && graph.on && !graph.dataset.clipWatched) {
        graph.dataset.clipWatched = "yes";
        const again = () => {
          forget();
          placeMarks();
        };
        graph.on("plotly_afterplot", again);
        new ResizeObserver(again).observe(need(CLIP_BOX));
      }
      forget();
      if (figure3 && figure3.layout && figure3.layout.meta && figure3.layout.meta.thinned) fetchValues(view4);
      requestAnimationFrame(() => requestAnimationFrame(() => {
        forget();
        placeMarks();
      }));
      return figure3?.layout?.meta?.kind ?? null;
    },
    /** @param {Selection | null} selection @param {ShownClip | null} shown */
    mark(selection, shown9) {
      at.shown = shown9;
      const { clip, start: start3 = 0, end = 0 } = selection ?? {};
      at.range = shown9 && clip === shown9.clip && end > start3 ? [start3, Math.min(end, shown9.frames)] : null;
      follow(standing2());
      return clientside.no_update;
    },
    /**
     * @param {string} value
     * @param {unknown} _back
     * @param {unknown} _next
     * @param {string[]} names
     * @param {ShownClip | null} shown
     */
    pick(value, _back, _next, names2, shown9) {
      const trigger = (clientside.callback_context.triggered[0] || {}).prop_id || "";
      const step3 = trigger.startsWith(CLIP_PREVIOUS) ? -1 : trigger.startsWith(CLIP_NEXT) ? 1 : 0;
      const clip = step3 ? names2[names2.indexOf(shown9 ? shown9.clip : value) + step3] : value;
      if (clip && (!shown9 || clip !== shown9.clip)) {
        changeView({ span: "" });
        setStore(SELECTION, { clip });
      }
      return clientside.no_update;
    },
    // Puts what was chosen above the chart into the view; what the server preselects is no choice.
    /**
     * @param {string} chart
     * @param {string} kind
     * @param {string[] | null} joints
     * @param {string[] | null} channels
     * @param {View | null} view
     * @param {{ joints?: string[], channels?: string[] } | null} choice
     */
    control(chart2, kind, joints, channels, view4, choice2) {
      const now6 = view4 || {};
      const same4 = (a, b) => JSON.stringify(a || []) === JSON.stringify(b || []);
      const trigger = (clientside.callback_context.triggered[0] || {}).prop_id || "";
      const change2 = {};
      if (trigger.startsWith(CLIP_CHART)) Object.assign(change2, { chart: chart2 === "angles" ? "" : chart2, joints: "" });
      if (trigger.startsWith(CLIP_KIND)) change2.angles = kind === "body" ? "" : kind;
      if (trigger.startsWith(CLIP_JOINTS)) change2[kind === "file" && chart2 === "angles" ? "rig" : "joints"] = (joints || []).join(",");
      if (trigger.startsWith(CLIP_CHANNELS)) change2.channels = (channels || []).join(",");
      if (trigger.startsWith(CLIP_JOINTS) && same4(joints, choice2 && choice2.joints)) return clientside.no_update;
      if (trigger.startsWith(CLIP_CHANNELS) && same4(channels, choice2 && choice2.channels)) return clientside.no_update;
      if (trigger.startsWith(CLIP_CHART) && (now6.chart || "angles") === chart2) return clientside.no_update;
      if (trigger.startsWith(CLIP_KIND) && (now6.angles || "body") === kind) return clientside.no_update;
      changeView(change2);
      return clientside.no_update;
    },
    /** @param {{ clip: string, frame: number } | null} to */
    seek(to) {
      if (to && at.shown && to.clip === at.shown.clip) seekFrame(to.frame);
      return clientside.no_update;
    },
    /** @param {object | null} edit */
    editAtFrame(edit) {
      return edit ? { ...edit, frame: frameNow2() ?? 0 } : clientside.no_update;
    }
  });

  // clip/zoom.mjs
  var LEAST = 4;
  function spanWithin(low, high, { frames, fps }) {
    const seconds = Math.max((frames - 1) / fps, 1 / fps);
    const width = clamp(high - low, Math.min(LEAST / fps, seconds), seconds);
    const from = clamp((low + high - width) / 2, 0, seconds - width);
    return { span: [from, from + width], whole: width >= seconds - 1e-6 };
  }

  // clip/range.mjs
  var CLOSE = 4;
  var box3 = (target2) => closest({ target: target2 }, `#${CLIP_BOX}`);
  var press = null;
  var frameAt = (plot, pixel) => clamp(Math.round(plot.time(pixel) * plot.meta.fps), 0, plot.meta.frames - 1);
  var inside = (plot, x, y) => x >= plot.left - 6 && x <= plot.left + plot.width + 6 && y >= plot.top && y <= plot.top + plot.height;
  function locate(event) {
    const plot = chartPlot();
    const area = find(CLIP_BOX);
    if (!plot || !area) return null;
    const { left, top } = area.getBoundingClientRect();
    return { plot, x: event.clientX - left, y: event.clientY - top };
  }
  document.addEventListener("pointerdown", (event) => {
    if (event.button || !box3(targetOf(event))) return;
    const spot = locate(event);
    if (!spot) return;
    const grip = Boolean(closest(event, ".clip-grip"));
    if (!grip && !inside(spot.plot, spot.x, spot.y)) return;
    press = { ...spot, id: event.pointerId, grip, moved: false };
    if (spot.plot.meta.kind === "time") box3(targetOf(event))?.setPointerCapture(event.pointerId);
  });
  document.addEventListener("pointermove", (event) => {
    const over = box3(targetOf(event));
    if (!press) {
      const spot2 = over && locate(event);
      const hover = spot2 && spot2.plot.meta.kind === "time" && inside(spot2.plot, spot2.x, spot2.y) ? frameAt(spot2.plot, spot2.x) : null;
      if (hover !== at.hover) {
        at.hover = hover;
        placeMarks();
      }
      return;
    }
    const spot = locate(event);
    if (!spot || event.pointerId !== press.id) return;
    if (Math.abs(spot.x - press.x) > CLOSE) press.moved = true;
    if (press.plot.meta.kind !== "time") return;
    if (press.grip) return seekFrame(frameAt(spot.plot, spot.x));
    if (!press.moved) return;
    const ends = [frameAt(spot.plot, press.x), frameAt(spot.plot, spot.x)].sort((a, b) => a - b);
    at.dragged = [ends[0], ends[1] + 1];
    at.hover = null;
    placeMarks();
  });
  document.addEventListener("pointerup", (event) => {
    if (!press || event.pointerId !== press.id) return;
    const { plot, moved: moved2, grip } = press;
    press = null;
    const dragged3 = at.dragged;
    at.dragged = null;
    if (grip) return;
    if (dragged3) return select2(dragged3);
    if (moved2) return;
    const spot = locate(event);
    if (!spot) return;
    if (plot.meta.kind === "path") return clickPath(spot);
    const picked = blockAt(spot);
    if (picked) select2(picked);
    else seekFrame(frameAt(spot.plot, spot.x));
  });
  document.addEventListener("pointercancel", () => {
    press = null;
    at.dragged = null;
    placeMarks();
  });
  document.addEventListener("pointerout", (event) => {
    if (at.hover === null || box3(event.relatedTarget)) return;
    at.hover = null;
    placeMarks();
  });
  function select2(range2) {
    const [start3, end] = range2;
    if (at.shown && end - start3 >= 2) setStore(SELECTION, { clip: at.shown.clip, start: start3, end });
    else placeMarks();
  }
  function blockAt({ plot, x, y }) {
    const seconds = plot.time(x);
    for (const trace of plot.graph.data) {
      if (!trace.meta || !trace.meta.picks) continue;
      const axis = plot.full["yaxis" + trace.yaxis.slice(1)];
      const row7 = axis.p2l(y - plot.top + plot.full._size.t - axis._offset);
      if (Math.abs(row7 - trace.meta.row) > 0.5) continue;
      const frame = seconds * plot.meta.fps;
      const hits = trace.meta.picks.filter(([start3, end]) => frame >= start3 && frame < end);
      const away = ([start3, end]) => Math.abs(frame - (start3 + end) / 2);
      const hit = hits.sort((a, b) => away(a) - away(b))[0];
      if (hit) return hit;
    }
    return null;
  }
  function clickPath({ plot, x, y }) {
    const path2 = plot.graph.data[0];
    let best = -1;
    let least = 30;
    for (let k = 0; k < path2.x.length; k++) {
      const away = Math.hypot(plot.x(path2.x[k]) - x, plot.y(path2.y[k]) - y);
      if (away < least) [best, least] = [k, away];
    }
    if (best >= 0) seekFrame(path2.customdata[best]);
  }
  var settling = 0;
  var moving = 0;
  var wanted = null;
  async function move() {
    const plot = chartPlot();
    const range2 = wanted;
    if (plot && range2) await window.Plotly.relayout(plot.graph, { "xaxis.range": range2 });
    moving = 0;
    if (range2 !== wanted) moving = requestAnimationFrame(move);
    else wanted = null;
  }
  function show(low, high) {
    const plot = chartPlot();
    if (!plot || plot.meta.kind !== "time") return;
    const { span, whole: whole3 } = spanWithin(low, high, plot.meta);
    wanted = span;
    if (!moving) moving = requestAnimationFrame(move);
    clearTimeout(settling);
    settling = setTimeout(() => changeView({ span: whole3 ? "" : span.map((second) => second.toFixed(3)).join("_") }), 160);
  }
  function zoom(what) {
    const plot = chartPlot();
    if (!plot) return;
    const [low, high] = plot.range;
    if (what === "whole") return show(0, Infinity === high ? 1 : plot.meta.frames / plot.meta.fps);
    const range2 = chosenRange();
    if (what === "range") {
      if (!range2) return;
      const [a, b] = range2.map((frame) => frame / plot.meta.fps);
      return show(a - 0.05 * (b - a), b + 0.05 * (b - a));
    }
    const cursor3 = at.frame === null ? NaN : at.frame / plot.meta.fps;
    scale(what === "in" ? 0.6 : 1 / 0.6, cursor3 >= low && cursor3 <= high ? cursor3 : (low + high) / 2);
  }
  function scale(factor, about) {
    const [low, high] = wanted || chartPlot()?.range || [0, 1];
    show(about + (low - about) * factor, about + (high - about) * factor);
  }
  document.addEventListener("wheel", (event) => {
    const spot = box3(targetOf(event)) && locate(event);
    if (!spot || spot.plot.meta.kind !== "time") return;
    const [low, high] = wanted || spot.plot.range;
    if (event.ctrlKey || event.metaKey) {
      event.preventDefault();
      scale(Math.exp(clamp(event.deltaY, -80, 80) / 200), spot.plot.time(spot.x));
    } else if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
      event.preventDefault();
      const way3 = (event.deltaX || event.deltaY) / spot.plot.width * (high - low);
      show(low + way3, high + way3);
    }
  }, { passive: false });
  document.addEventListener("click", (event) => {
    const button5 = closest(event, "[data-clip-zoom]");
    if (button5) zoom(button5.dataset.clipZoom);
  });
  function setEnd(which) {
    const frame = frameNow2();
    if (frame === null || !at.shown) return;
    const [start3, end] = chosenRange() || [0, at.shown.frames];
    select2(which === "start" ? [frame, end > frame ? end : at.shown.frames] : [start3 < frame ? start3 : 0, frame + 1]);
  }
  var step = (by) => {
    player.pause();
    seekFrame((frameNow2() ?? 0) + by);
  };
  var KEYS4 = {
    ArrowLeft: (far) => step(far ? -10 : -1),
    ArrowRight: (far) => step(far ? 10 : 1),
    Home: () => seekFrame(0),
    End: () => at.shown && seekFrame(at.shown.frames - 1),
    "[": () => setEnd("start"),
    "]": () => setEnd("end"),
    Escape: () => at.shown && setStore(SELECTION, { clip: at.shown.clip }),
    "+": () => zoom("in"),
    "=": () => zoom("in"),
    "-": () => zoom("out"),
    0: () => zoom("whole"),
    " ": () => player[player.playing ? "pause" : "play"]()
  };
  document.addEventListener("keydown", (event) => {
    if (targetOf(event).id !== CLIP_BOX || event.ctrlKey || event.metaKey || event.altKey || !KEYS4[event.key]) return;
    event.preventDefault();
    KEYS4[event.key](event.shiftKey);
  });

  // motifs/ids.mjs
  var MOTIF_GRAPH = "motif-graph";
  var EDGE_FILTER_LABEL = "edge-filter-label";
  var GRAPH_PART = "graph-part";
  var GRAPH_SOUGHT = (
    /** @type {StoreId<Record<string, number>>} */
    "graph-sought"
  );
  var MOTIF_TABLE = "motif-table";
  var MOTION_LIST = "motion-list";
  var TIMELINE_LEGEND = "timeline-legend";
  var TIMELINE_ROWS = "timeline-rows";
  var COMPARE_FLOW = "compare-flow";
  var BLEND_HINT = "blend-hint";
  var BLEND_PANEL = "blend-panel";
  var BLEND_TITLE = "blend-title";
  var BLEND_COUNT = "blend-count";
  var BLEND_CONTROLS = "blend-controls";
  var BLEND_BVH = "blend-bvh";
  var BLEND_NOTE = "blend-note";
  var WALK_LENGTH = "walk-length";
  var WALK_HINT = "walk-hint";
  var WALK_PATH = "walk-path";
  var WALK_ERROR = "walk-error";
  var WALK_METERS = "walk-meters";
  var WALK_BVH = "walk-bvh";
  var WALK_JSON = "walk-json";
  var WALK_NOTES = "walk-notes";
  var WALK_ADD = "walk-add";
  var WALK_FROM = "walk-from";
  var WALK_TO = "walk-to";
  var WALK_SECONDS = "walk-seconds";
  var WALK_SEED = "walk-seed";
  var WALK_EXTRA = "walk-extra";
  var WALK_BRIDGE = "walk-bridge";
  var WALK_STOP = "walk-stop";
  var WALK_FEET = "walk-feet";
  var WALK_WAYS = "walk-ways";
  var STABILITY_LEGEND = "stability-legend";
  var STABILITY_WORDS = "stability-words";

  // motifs/triangle.mjs
  var CORNERS = [[150, 26], [28, 214], [272, 214]];
  var CORNER = 0.03;
  var placeOf2 = (weights) => [0, 1].map((axis) => weights.reduce((total3, w, k) => total3 + w * CORNERS[k][axis], 0));
  function weightsAt(x, y) {
    const [[ax, ay], [bx, by], [cx, cy]] = CORNERS;
    const area = (by - cy) * (ax - cx) + (cx - bx) * (ay - cy);
    const a = ((by - cy) * (x - cx) + (cx - bx) * (y - cy)) / area;
    const b = ((cy - ay) * (x - cx) + (ax - cx) * (y - cy)) / area;
    return insideWeights([a, b, 1 - a - b]);
  }
  function insideWeights(weights) {
    const kept = weights.map((w) => Math.max(w, 0));
    const total3 = kept.reduce((sum2, w) => sum2 + w, 0) || 1;
    const shares2 = kept.map((w) => w / total3);
    const corner = shares2.findIndex((w) => w > 1 - CORNER);
    return shares2.map((w, k) => corner < 0 ? w : Number(k === corner));
  }
  function awayFromCorner(corner, [dx, dy]) {
    const [x, y] = CORNERS[corner];
    const gains = CORNERS.map(([cx, cy], k) => k === corner ? 0 : (cx - x) * dx + (cy - y) * dy);
    const best = gains.indexOf(Math.max(...gains));
    if (gains[best] <= 0) return [0, 1, 2].map((k) => Number(k === corner));
    return [0, 1, 2].map((k) => k === corner ? 1 - 2 * CORNER : k === best ? 2 * CORNER : 0);
  }

  // motifs/blend_controls.mjs
  var html = (name, attributes, text) => withAttributes(element(name, "", text), attributes);
  var LABELS = [[150, 14], [18, 232], [282, 232]];
  var STEP2 = 0.02;
  function triangle(state3, actions4) {
    const svg = svgElement("svg", { viewBox: "0 0 300 240", class: "blend-triangle" });
    svg.append(svgElement("polygon", { points: CORNERS.map((c) => c.join()).join(" "), class: "blend-field" }));
    CORNERS.forEach((corner, k) => {
      const [x, y] = LABELS[k];
      svg.append(svgElement("line", { x1: corner[0], y1: corner[1], x2: (CORNERS[(k + 1) % 3][0] + CORNERS[(k + 2) % 3][0]) / 2, y2: (CORNERS[(k + 1) % 3][1] + CORNERS[(k + 2) % 3][1]) / 2, class: "blend-median" }));
      svg.append(svgElement("circle", { cx: corner[0], cy: corner[1], r: 4, class: "blend-corner" }));
      svg.append(svgElement("text", { x, y, "text-anchor": "middle", class: "blend-corner-label" }, String(state3.chosen[k] + 1)));
    });
    const point = svgElement("circle", {
      r: 10,
      class: "blend-point",
      tabindex: 0,
      role: "slider",
      "aria-label": "Mixture of three motions",
      "aria-valuemin": 0,
      "aria-valuemax": 100
    });
    svg.append(point);
    const at3 = (event) => {
      const spot = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM()?.inverse());
      actions4.set(weightsAt(spot.x, spot.y));
    };
    svg.addEventListener("pointerdown", (event) => {
      svg.setPointerCapture(event.pointerId);
      point.focus();
      at3(event);
      event.preventDefault();
    });
    svg.addEventListener("pointermove", (event) => {
      if (svg.hasPointerCapture(event.pointerId)) at3(event);
    });
    point.addEventListener("keydown", (event) => press2(event, state3, actions4));
    return svg;
  }
  function press2(event, state3, actions4) {
    const ways = { ArrowUp: [0, -1], ArrowDown: [0, 1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] };
    if (ways[event.key]) {
      const [x, y] = placeOf2(insideWeights(state3.values));
      const far = (event.shiftKey ? 5 : 1) * STEP2 * 244;
      let weights = weightsAt(x + ways[event.key][0] * far, y + ways[event.key][1] * far);
      const corner = state3.values.findIndex((w) => w === 1);
      if (corner >= 0 && weights[corner] === 1) weights = awayFromCorner(corner, ways[event.key]);
      actions4.set(weights);
    } else if ("0123".includes(event.key)) {
      actions4.set(event.key === "0" ? [1, 1, 1].map((w) => w / 3) : [0, 1, 2].map((k) => Number(k === Number(event.key) - 1)));
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }
  function row2(state3, i, actions4) {
    const { motion, clip, brief, when } = state3.data.bodies[state3.body].motions.find((one) => one.motion === state3.chosen[i]) ?? state3.data.bodies[state3.body].motions[0];
    const made = html("div", { class: "blend-row" });
    const name = `Motion ${motion + 1}: ${clip}, ${when}`;
    const only = html("button", { type: "button", class: "blend-badge number", title: `Only motion ${motion + 1}`, "aria-label": `Only motion ${motion + 1}` }, String(motion + 1));
    only.addEventListener("click", () => actions4.set(state3.values.map((_, k) => Number(k === i))));
    const middle = html("div", { class: "blend-middle" });
    middle.append(html("span", { class: "ellipsis blend-name", title: name }, `${brief} · ${when.split(" ")[0]}`));
    if (state3.chosen.length !== 3) {
      const range2 = html("input", { type: "range", min: 0, max: 1, step: 0.01, "aria-label": `Weight of ${name}` });
      range2.addEventListener("input", () => actions4.set(state3.values.map((value, k) => k === i ? Number(range2.value) : value)));
      middle.append(range2);
    }
    made.append(only, middle, html("span", { class: "number muted blend-share" }));
    if (state3.chosen.length > 2) {
      const remove = html("button", { type: "button", class: "blend-remove", title: "Leave this motion out", "aria-label": `Leave motion ${motion + 1} out` }, "×");
      remove.addEventListener("click", () => actions4.remove(motion));
      made.append(remove);
    }
    return made;
  }
  function choice(label, options, act2) {
    const select3 = html("select", { class: "blend-choice", "aria-label": label });
    for (const [value, text] of options) select3.append(html("option", { value }, text));
    select3.addEventListener("change", () => act2(select3.value));
    return select3;
  }
  function drawControls(box4, state3, shares2, actions4) {
    const { bodies, most } = state3.data;
    const controls = [];
    if (bodies.length > 1) {
      const bodyChoice = choice("Body", bodies.map(({ motions: motions2 }, k) => (
        /** @type {[number, string]} */
        [k, `Body ${k + 1}: ${motions2.length} motions`]
      )), (value) => actions4.body(Number(value)));
      bodyChoice.value = String(state3.body);
      controls.push(bodyChoice);
    }
    if (state3.chosen.length === 3) controls.push(triangle(state3, actions4));
    const rows2 = html("div", { class: "blend-rows" });
    rows2.append(...state3.chosen.map((_, i) => row2(state3, i, actions4)));
    controls.push(rows2);
    const others = bodies[state3.body].motions.filter(({ motion }) => !state3.chosen.includes(motion));
    if (others.length && state3.chosen.length < most) {
      const options = [["", "Add a motion …"], ...others.map(({ motion, brief, when }) => (
        /** @type {[number, string]} */
        [motion, `${motion + 1}  ${brief} · ${when.split(" ")[0]}`]
      ))];
      controls.push(choice("Add a motion", options, (value) => value && actions4.add(Number(value))));
    }
    box4.replaceChildren(...controls);
    updateControls(state3, shares2);
  }
  function updateControls(state3, shares2) {
    const box4 = find(BLEND_CONTROLS);
    if (!box4) return;
    allWithin(box4, ".blend-row").forEach((made, i) => {
      within(made, ".blend-share").textContent = percent(shares2[i]);
      made.style.setProperty("--share", String(shares2[i]));
      const range2 = made.querySelector("input");
      if (range2 && Number(range2.value) !== state3.values[i]) range2.value = String(state3.values[i]);
      if (range2) range2.setAttribute("aria-valuetext", percent(shares2[i]));
    });
    const point = box4.querySelector(".blend-point");
    if (!point) return;
    const [x, y] = placeOf2(shares2);
    point.setAttribute("cx", x.toFixed(1));
    point.setAttribute("cy", y.toFixed(1));
    point.setAttribute("aria-valuenow", String(Math.round(100 * shares2[0])));
    point.setAttribute("aria-valuetext", shares2.map((share2, k) => `motion ${state3.chosen[k] + 1} ${percent(share2)}`).join(", "));
  }

  // motifs/mixture.mjs
  var sum = (values) => values.reduce((total3, value) => total3 + value, 0);
  var rounded = (value) => String(Math.round(value * 100) / 100);
  var writePairs = (motions2, values) => motions2.map((motion, i) => `${motion}:${rounded(values[i])}`).join(",");
  var evenWeight = (n) => n > 3 ? 0.5 : 1 / n;
  function interpolate(x, xs, ys) {
    let k = 1;
    while (k < xs.length - 1 && xs[k] < x) k++;
    const part2 = (x - xs[k - 1]) / Math.max(xs[k] - xs[k - 1], 1e-9);
    return ys[k - 1] + (ys[k] - ys[k - 1]) * Math.min(Math.max(part2, 0), 1);
  }
  function inStep(used) {
    const knots = used[0].one.seconds.map((_, i) => i);
    const times = knots.map((i) => sum(used.map(({ one, share: share2 }) => share2 * one.seconds[i])));
    const last3 = times.at(-1) ?? 0;
    const fps = Math.max(...used.map(({ one }) => one.fps));
    const n = Math.round(last3 * fps) + 1;
    const at3 = Array.from({ length: n }, (_, j) => interpolate(j / Math.max(n - 1, 1) * last3, times, knots));
    const own2 = ({ one }) => at3.map((u) => Math.min(Math.round(interpolate(u, knots, one.seconds) * one.fps * 100) / 100, one.end - one.start - 1));
    return { mixture: at3.map((_, j) => j), sources: used.map(own2) };
  }
  function sharesOf(values) {
    const total3 = sum(values);
    return values.map((value) => total3 > 0 ? value / total3 : 1 / values.length);
  }
  var readPairs = (text) => [...(text || "").matchAll(/(\d+):([\d.]+)/g)].map(([, motion, value]) => [Number(motion), Math.min(Number(value) || 0, 1)]);

  // motifs/blend.mjs
  var OURS = "~blend~";
  var WAIT = 300;
  var SOURCE = { light: "#9aa5b4", dark: "#7c8797" };
  var now = (
    /** @type {any} */
    null
  );
  var seen;
  var writing2 = 0;
  var motionOf2 = (motion) => (
    /** @type {BlendMotion} */
    now.data.bodies[now.body].motions.find((one) => one.motion === motion)
  );
  var shares = () => sharesOf(now.values);
  function linkText() {
    const { data: data2, body: body2, chosen: chosen3, values } = now;
    const first = body2 === 0 && chosen3.join() === data2.bodies[0].chosen.join() && values.every((v) => v === values[0]);
    return first ? "" : writePairs(chosen3, values);
  }
  function read(text) {
    const pairs = readPairs(text);
    const body2 = now.data.bodies.findIndex(({ motions: motions2 }) => pairs.length > 1 && pairs.every(([k]) => motions2.some((one) => one.motion === k)));
    if (body2 < 0) return false;
    const kept = pairs.slice(0, now.data.most);
    Object.assign(now, { body: body2, chosen: kept.map(([k]) => k), values: kept.map(([, v]) => v), written: text ?? "" });
    return true;
  }
  function start2(body2) {
    const chosen3 = [...now.data.bodies[body2].chosen];
    Object.assign(now, { body: body2, chosen: chosen3, values: chosen3.map(() => evenWeight(chosen3.length)) });
  }
  function mixtureName() {
    const used = shares().map((share2, i) => (
      /** @type {[number, number]} */
      [now.chosen[i], share2]
    )).filter(([, share2]) => rounded(share2) !== "0");
    used.sort(([a], [b]) => a - b);
    return `${OURS}${now.data.key}~${now.data.motif}~${writePairs(used.map(([k]) => k), used.map(([, share2]) => share2))}`;
  }
  function request() {
    const { data: data2 } = now;
    const made = { dataset: mixtureName(), clip: "blend", label: "Mixture" };
    const title = `${data2.title}: mixture of ${shares().filter((share2) => rounded(share2) !== "0").length}`;
    if (!now.sources) return { dataset: data2.dataset, items: [made], layout: "overlay", sync: "warp", title };
    const used = shares().map((share2, i) => ({ share: share2, one: motionOf2(now.chosen[i]) })).filter(({ share: share2 }) => rounded(share2) !== "0");
    const warps = inStep(used);
    const colour = SOURCE[document.documentElement.dataset.mantineColorScheme ?? ""] || SOURCE.light;
    const items = used.map(({ one }, i) => ({
      clip: one.clip,
      start: one.start,
      end: one.end,
      label: `Motion ${one.motion + 1}`,
      version: data2.version,
      colour,
      warp: warps.sources[i]
    }));
    return { dataset: data2.dataset, items: [{ ...made, warp: warps.mixture }, ...items], layout: "overlay", sync: "warp", title };
  }
  var onStage = () => Boolean(player.frameOf(0)?.dataset?.startsWith(OURS));
  function play3() {
    const mixture = request();
    if (onStage()) player.replace(mixture);
    else player.show(mixture);
    const link2 = find(BLEND_BVH);
    if (link2) link2.setAttribute("href", `/api/bvh/${encodeURIComponent(mixtureName())}/blend`);
  }
  function write2() {
    clearTimeout(writing2);
    writing2 = setTimeout(() => {
      if (!now) return;
      now.written = linkText();
      changeView({ weights: now.written });
    }, WAIT);
  }
  function changed() {
    updateControls(now, shares());
    play3();
    write2();
  }
  function chooseAgain(body2, chosen3, values) {
    Object.assign(now, { body: body2, chosen: chosen3, values });
    show2();
    write2();
  }
  var actions = {
    mean: () => now.values.fill(evenWeight(now.values.length)),
    random() {
      const drawn8 = now.values.map(() => -Math.log(Math.max(Math.random(), 1e-9)));
      const scale3 = now.values.length > 3 ? Math.max(...drawn8) : sum(drawn8);
      now.values = drawn8.map((value) => Math.round(value / scale3 * 100) / 100);
    },
    sources() {
      now.sources = !now.sources;
    }
  };
  var controlActions = {
    /** @param {number[]} values */
    set(values) {
      now.values = values;
      changed();
    },
    /** @param {number} number */
    body(number2) {
      start2(number2);
      chooseAgain(now.body, now.chosen, now.values);
    },
    /** @param {number} motion */
    add(motion) {
      const chosen3 = [...now.chosen, motion];
      chooseAgain(now.body, chosen3, chosen3.map(() => evenWeight(chosen3.length)));
    },
    /** @param {number} motion */
    remove(motion) {
      const chosen3 = now.chosen.filter((one) => one !== motion);
      chooseAgain(now.body, chosen3, chosen3.map(() => evenWeight(chosen3.length)));
    }
  };
  document.addEventListener("click", (event) => {
    const button5 = closest(event, "[data-blend]");
    if (!button5 || !now) return;
    const action = button5.dataset.blend;
    if (action === "middles") return player.show(now.data.middles);
    actions[action ?? ""]();
    if (action === "sources") button5.setAttribute("aria-pressed", String(now.sources));
    changed();
  });
  function show2(quiet2) {
    const { data: data2 } = now;
    need(BLEND_TITLE).textContent = data2.title;
    const body2 = data2.bodies[now.body];
    need(BLEND_COUNT).textContent = `${now.chosen.length} of ${data2.total} motions`;
    const others = data2.total - body2.motions.length;
    need(BLEND_NOTE).textContent = others ? `${others} of its ${data2.total} motions are of other bodies; only motions of one body can be mixed.` : "";
    drawControls(need(BLEND_CONTROLS), now, shares(), controlActions);
    if (!quiet2) play3();
  }
  function message(text) {
    need(BLEND_HINT).textContent = text;
    need(BLEND_HINT).classList.toggle("hidden", !text);
    need(BLEND_PANEL).classList.toggle("hidden", Boolean(text));
  }
  function leave(selection) {
    if (now && onStage() && selection) setStore(SELECTION, { ...selection });
    now = /** @type {any} */
    null;
  }
  function begin2(data2, view4, selection, linked) {
    now = { data: data2, body: 0, chosen: [], values: [], sources: false, written: "" };
    start2(0);
    if (linked && view4.weights) read(view4.weights);
    else if (view4.weights) changeView({ weights: "" });
    const stills = !seen && new URLSearchParams(location.search).get("layout") === "pose";
    show2(stills || selection && selection.motion !== void 0);
    if (stills) player.show(data2.middles);
    within(document, "[data-blend='sources']").setAttribute("aria-pressed", "false");
  }
  function take2(data2, view4, selection) {
    const name = `${data2.key} ${data2.motif}`;
    const linked = !seen || seen === name;
    if (data2.motif === void 0 || data2.motif === null) {
      now = /** @type {any} */
      null;
      message("Choose a motif to mix its motions.");
    } else if (!data2.bodies || !data2.bodies.length) {
      now = /** @type {any} */
      null;
      message("No two motions of this motif are of one body, so there is nothing to mix.");
      if (data2.together && seen !== name) player.show(data2.together);
    } else {
      message("");
      if (!now || `${now.data.key} ${now.data.motif}` !== name) begin2(data2, view4, selection, linked);
      else if (!need(BLEND_CONTROLS).childElementCount) show2(true);
      else if ((view4.weights || "") !== now.written && read(view4.weights)) show2();
    }
    seen = name;
  }
  register("blend", {
    /**
     * @param {BlendData | null} data
     * @param {View | null} view
     * @param {unknown} _id
     * @param {Selection | null} selection
     */
    draw(data2, view4, _id, selection) {
      if (!view4 || view4.side !== "blend") {
        leave(selection);
        return clientside.no_update;
      }
      if (!data2 || !find(BLEND_PANEL)) return clientside.no_update;
      take2(data2, view4, selection);
      return clientside.no_update;
    }
  });

  // motifs/compare.mjs
  var BAR = 12;
  var LABEL = 40;
  var LEAST_LABEL = 9;
  var shown5 = null;
  var drawing3 = (name, attributes, title) => svgElement(name, attributes, ...title ? [svgElement("title", {}, title)] : []);
  function choose2(a, b) {
    if (a !== null && a !== void 0) return setStore(SELECTION, { motif: a });
    if (b === null || b === void 0) return;
    changeView({ gained: String(b) });
    setStore(SELECTION, {});
  }
  function here(bar) {
    if (bar.side === "a") return bar.motif;
    const links = (shown5?.data.ribbons ?? []).filter((r) => r.b === bar.motif && r.a !== null && r.kind !== "rest");
    return links.length ? links.reduce((best, r) => r.h > best.h ? r : best).a : null;
  }
  function pressable(node, label, act2) {
    node.setAttribute("tabindex", "0");
    node.setAttribute("role", "button");
    node.setAttribute("aria-label", label);
    node.addEventListener("click", act2);
    node.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      act2();
    });
  }
  function drawBar(svg, bar, width) {
    const left = bar.side === "a";
    const x = left ? LABEL : width - LABEL - BAR;
    const group = drawing3("g", { class: `flow-bar change-${bar.change || "none"}`, "data-side": bar.side, "data-motif": bar.motif ?? "" }, bar.title);
    group.appendChild(drawing3("rect", { x, y: bar.y, width: BAR, height: Math.max(bar.h, 1), rx: 2 }));
    if (bar.h >= LEAST_LABEL) {
      const at3 = { x: left ? x - 6 : x + BAR + 6, y: bar.y + bar.h / 2, "text-anchor": left ? "end" : "start" };
      group.appendChild(drawing3("text", { ...at3, "dominant-baseline": "central" })).textContent = bar.label;
    }
    if (bar.motif !== null) pressable(group, bar.title, () => choose2(here(bar), bar.motif));
    svg.appendChild(group);
  }
  function drawRibbon(svg, ribbon, width, changes) {
    const [x0, x1] = [LABEL + BAR + 1, width - LABEL - BAR - 1];
    const bend = (x0 + x1) / 2, { ya, yb, h } = ribbon;
    const path2 = `M${x0},${ya} C${bend},${ya} ${bend},${yb} ${x1},${yb} L${x1},${yb + h} C${bend},${yb + h} ${bend},${ya + h} ${x0},${ya + h} Z`;
    const change2 = ribbon.kind === "kept" ? "kept" : ribbon.kind === "linked" ? changes(ribbon) : "none";
    const one = drawing3("path", { d: path2, class: `flow-ribbon change-${change2}`, "data-a": ribbon.a ?? "", "data-b": ribbon.b ?? "" }, ribbon.title);
    one.addEventListener("click", () => choose2(ribbon.a, ribbon.b));
    svg.appendChild(one);
  }
  function draw5() {
    const box4 = find(COMPARE_FLOW);
    if (!box4 || !shown5 || !shown5.data || !box4.clientWidth) return;
    const width = box4.clientWidth, { height, bars, ribbons } = shown5.data;
    const svg = drawing3("svg", { width, height, viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": "Motion that motifs of both results share" });
    const change2 = new Map(bars.map((bar) => [bar.side + bar.motif, bar.change]));
    const changes = (ribbon) => change2.get("a" + ribbon.a) === "kept" ? change2.get("b" + ribbon.b) : change2.get("a" + ribbon.a);
    const rank = { rest: 0, linked: 1, kept: 2 };
    [...ribbons].sort((r, s) => rank[r.kind] - rank[s.kind]).forEach((ribbon) => drawRibbon(svg, ribbon, width, changes));
    bars.forEach((bar) => drawBar(svg, bar, width));
    box4.replaceChildren(svg);
    mark();
  }
  function mark() {
    const box4 = find(COMPARE_FLOW);
    if (!box4 || !shown5) return;
    const a = String(shown5.selection?.motif ?? ""), b = a ? "" : String(shown5.gained ?? "");
    const touches = (node) => a && node.dataset.a === a || b && node.dataset.b === b || node.dataset.side === "a" && a && node.dataset.motif === a || node.dataset.side === "b" && b && node.dataset.motif === b;
    box4.classList.toggle("some-chosen", Boolean(a || b));
    for (const node of allWithin(box4, ".flow-bar, .flow-ribbon")) node.classList.toggle("chosen", Boolean(touches(node)));
  }
  var watched = /* @__PURE__ */ new WeakSet();
  function watch2(box4) {
    if (watched.has(box4)) return;
    watched.add(box4);
    let width = 0;
    new ResizeObserver(() => {
      if (box4.clientWidth && box4.clientWidth !== width) draw5();
      width = box4.clientWidth;
    }).observe(box4);
  }
  register("compare", {
    /** @param {Flow | null} data @param {Selection | null} selection @param {View | null} view */
    draw(data2, selection, view4) {
      shown5 = data2 && { data: data2, selection, gained: (view4 || {}).gained };
      const box4 = find(COMPARE_FLOW);
      if (!data2 || !box4) return clientside.no_update;
      watch2(box4);
      draw5();
      return clientside.no_update;
    },
    /** @param {any} request */
    play(request5) {
      if (request5) setStore(STAGE_REQUEST, request5);
      return clientside.no_update;
    },
    /** @param {Selection | null} selection @param {View | null} view */
    mark(selection, view4) {
      if (shown5) Object.assign(shown5, { selection, gained: (view4 || {}).gained });
      mark();
      return clientside.no_update;
    }
  });
  var WORDS2 = { kept: "Kept", split: "Split", merged: "Merged", lost: "Gone", gained: "New" };
  cellRenderers.Change = (props) => props.value ? reactElement("span", { className: "change-mark change-" + props.value }, WORDS2[props.value] || props.value) : null;
  cellRenderers.Share = (props) => typeof props.value === "number" ? reactElement(
    "span",
    { className: "share-bar number", title: Math.round(100 * props.value) + " %" },
    reactElement("span", { className: "share-track" }, reactElement("span", { className: "share-fill", style: { width: 100 * props.value + "%" } })),
    reactElement("span", { className: "share-number" }, Math.round(100 * props.value) + " %")
  ) : null;

  // motifs/walk_state.mjs
  var walking = { on: false };

  // motifs/graph.mjs
  var ID = MOTIF_GRAPH;
  var STEPS = { ArrowLeft: [60, 0], ArrowRight: [-60, 0], ArrowUp: [0, 60], ArrowDown: [0, -60] };
  async function graphReady(tries = 100) {
    for (let i = 0; i < tries; i++) {
      const box4 = (
        /** @type {any} */
        find(ID)
      );
      const cy = (
        /** @type {Cytoscape | undefined} */
        box4?._cyreg?.cy
      );
      if (cy && !cy.destroyed() && cy.elements().length) return cy;
      await new Promise((resolve) => setTimeout(resolve, 30));
    }
    return null;
  }
  function chosenIn(cy, selection) {
    if (!selection) return cy.collection();
    if (selection.motif !== void 0) return cy.getElementById("m" + selection.motif);
    if (selection.motifs !== void 0) return cy.nodes().filter((node) => selection.motifs?.split("-").includes(String(node.data("motif"))) ?? false);
    if (selection.edge !== void 0) return cy.getElementById("e" + selection.edge);
    return cy.collection();
  }
  var selectionOf = (element2) => element2.isNode() ? { motif: element2.data("motif") } : { edge: element2.data("edge") };
  var watched2 = /* @__PURE__ */ new WeakSet();
  var parts = /* @__PURE__ */ new WeakMap();
  var sought;
  function watch3(cy) {
    if (watched2.has(cy)) return;
    watched2.add(cy);
    const box4 = cy.container();
    box4.tabIndex = 0;
    box4.setAttribute("role", "application");
    box4.setAttribute("aria-label", "Motif graph. Arrow keys move, plus and minus zoom, 0 shows all. The table below lists the same motifs.");
    box4.addEventListener("keydown", (event) => {
      const step3 = STEPS[event.key];
      if (step3) cy.panBy({ x: step3[0], y: step3[1] });
      else if (event.key === "+" || event.key === "=") zoom2(cy, 1.25);
      else if (event.key === "-") zoom2(cy, 0.8);
      else if (event.key === "0") cy.fit(void 0, 26);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
    let touched = false;
    cy.on("pan zoom", (event) => {
      if (event.target === cy && cy._byHand) touched = true;
    });
    box4.addEventListener("wheel", () => {
      touched = true;
    }, { passive: true });
    box4.addEventListener("pointerdown", () => {
      touched = true;
    });
    new ResizeObserver(() => {
      if (cy.destroyed()) return;
      cy.resize();
      if (!touched) cy.fit(void 0, 26);
    }).observe(box4);
    cy.on("mouseover", "node, edge", (event) => {
      box4.style.cursor = "pointer";
      event.target.addClass("pointed");
      readable(cy);
      ahead.prepare(selectionOf(event.target), true);
    });
    cy.on("mouseout", "node, edge", (event) => {
      box4.style.cursor = "";
      event.target.removeClass("pointed");
      readable(cy);
      ahead.leave();
    });
    let pressed = null;
    cy.on("tapstart", "node, edge", (event) => {
      pressed = event;
      ahead.prepare(selectionOf(event.target));
    });
    cy.on("tapend", "node, edge", (event) => {
      const [a, b] = [pressed?.renderedPosition, event.renderedPosition];
      const tapped = pressed?.target === event.target && a !== void 0 && Math.hypot(a.x - b.x, a.y - b.y) < 6;
      if (tapped && !walking.on) ahead.play(selectionOf(event.target));
    });
    cy.on("zoom", () => cy.elements(".readable").data("letters", letters(cy)));
    const looks = new MutationObserver(() => cy.destroyed() ? looks.disconnect() : rasterise(cy));
    looks.observe(document.documentElement, { attributes: true, attributeFilter: ["data-mantine-color-scheme"] });
    cy.autoungrabify(true);
    cy.fit(void 0, 26);
  }
  var letters = (cy) => Math.max(12, 11 / cy.zoom());
  function readable(cy) {
    const wanted2 = cy.elements(".pointed, .chosen, edge.near");
    cy.batch(() => {
      cy.elements(".readable").difference(wanted2).removeClass("readable");
      wanted2.data("letters", letters(cy)).addClass("readable");
    });
  }
  var SHARPNESS = 3;
  var drawn2 = /* @__PURE__ */ new Map();
  function pixels(address3, width, height) {
    const key = `${width}x${height} ${address3}`;
    if (!drawn2.has(key)) {
      drawn2.set(key, new Promise((resolve) => {
        const image = new Image();
        image.onload = () => {
          const scale3 = SHARPNESS * Math.min(width / image.width, height / image.height);
          const canvas = document.createElement("canvas");
          canvas.width = Math.max(1, Math.round(image.width * scale3));
          canvas.height = Math.max(1, Math.round(image.height * scale3));
          context2d(canvas).drawImage(image, 0, 0, canvas.width, canvas.height);
          canvas.toBlob((blob) => resolve(blob ? URL.createObjectURL(blob) : address3));
        };
        image.onerror = () => resolve(address3);
        image.src = address3;
      }));
    }
    return drawn2.get(key);
  }
  async function rasterise(cy) {
    const field = "icon_" + (document.documentElement.dataset.mantineColorScheme || "light");
    const vector = cy.nodes().filter((node) => (node.data(field) || "").startsWith("data:image/svg"));
    const images = await Promise.all(vector.map((node) => pixels(node.data(field), node.data("width"), node.data("height"))));
    if (cy.destroyed()) return;
    cy.batch(() => vector.forEach((node, i) => {
      node.data(field, images[i]);
    }));
    cy.container().dataset.drawn = "yes";
  }
  function zoom2(cy, factor) {
    const box4 = cy.container().getBoundingClientRect();
    cy.zoom({ level: cy.zoom() * factor, renderedPosition: { x: box4.width / 2, y: box4.height / 2 } });
  }
  var taps = 0;
  register("graph", {
    /** @param {{ motif: number } | null} node @param {{ edge: string } | null} edge */
    async tapped(node, edge) {
      if (walking.on) return clientside.no_update;
      const which = clientside.callback_context.triggered.map((item) => item.prop_id).join(" ");
      const mine2 = ++taps;
      await ahead.settled();
      if (mine2 !== taps) return clientside.no_update;
      if (which.includes("tapNodeData") && node) setStore(SELECTION, { motif: node.motif });
      else if (which.includes("tapEdgeData") && edge) setStore(SELECTION, { edge: edge.edge });
      return clientside.no_update;
    },
    /** @param {Selection | null} selection @param {number | null} threshold */
    async mark(selection, threshold) {
      const cy = await graphReady();
      if (!cy) return clientside.no_update;
      watch3(cy);
      const part2 = cy.nodes().map((node) => node.id()).join(" ");
      if (parts.get(cy) !== part2 && parts.has(cy)) cy.fit(void 0, 26);
      parts.set(cy, part2);
      const choice2 = selection?.motif ?? selection?.edge;
      if (choice2 !== void 0 && choice2 !== sought && chosenIn(cy, selection).empty() && find(GRAPH_PART)) {
        setStore(GRAPH_SOUGHT, { at: Date.now() });
      }
      sought = choice2;
      rasterise(cy);
      const label = find(EDGE_FILTER_LABEL);
      if (label) label.textContent = `Transitions seen at least ${threshold || 1}×`;
      cy.batch(() => {
        cy.elements().removeClass("chosen near faded rare");
        const chosen3 = chosenIn(cy, selection);
        const near = chosen3.length === 1 && chosen3.isNode() ? chosen3.closedNeighborhood() : chosen3.union(chosen3.connectedNodes());
        cy.edges().forEach((edge) => {
          if (edge.data("count") < (threshold || 1) && !near.contains(edge)) edge.addClass("rare");
        });
        if (chosen3.nonempty()) {
          cy.elements().difference(near).addClass("faded");
          near.difference(chosen3).addClass("near");
          chosen3.addClass("chosen");
        }
        readable(cy);
      });
      return clientside.no_update;
    },
    /** @param {{ graph?: string } | null} request @param {string | null} dataset */
    async tool(request5, dataset2) {
      const cy = request5 && await graphReady(10);
      if (!cy) return clientside.no_update;
      const background = getComputedStyle(document.documentElement).getPropertyValue("--surface").trim();
      const name = (dataset2 || "motifs") + "-graph";
      if (request5.graph === "in") zoom2(cy, 1.3);
      else if (request5.graph === "out") zoom2(cy, 1 / 1.3);
      else if (request5.graph === "fit") cy.animate({ fit: { padding: 26 }, duration: 200 });
      else if (request5.graph === "png") save(await cy.png({ output: "blob-promise", full: true, scale: 2, bg: background, maxWidth: 8e3, maxHeight: 8e3 }), name + ".png");
      return clientside.no_update;
    }
  });

  // motifs/motion_list.mjs
  function row3({ clip, brief, when, strip, selection, chosen: chosen3 }) {
    const button5 = element("button", "motion-row" + (chosen3 ? " chosen" : ""));
    button5.type = "button";
    button5.title = `Play ${clip}, ${when}, alone`;
    button5.dataset.store = SELECTION;
    button5.dataset.value = JSON.stringify(selection);
    button5.setAttribute("aria-pressed", String(chosen3));
    const picture2 = element("img", "motion-strip");
    Object.assign(picture2, { loading: "lazy", alt: "", draggable: false, src: strip });
    button5.append(icon("play"), element("span", "ellipsis motion-clip", brief), element("span", "muted number motion-time", when), picture2);
    return button5;
  }
  register("motions", {
    /** @param {{ name?: string, rows?: MotionRow[], more?: number } | null} motions */
    list(motions2) {
      const box4 = find(MOTION_LIST);
      if (!box4) return clientside.no_update;
      const { name = "", rows: rows2 = [], more: more2 = 0 } = motions2 || {};
      const same4 = box4.dataset.name === name;
      const top = same4 ? box4.scrollTop : 0;
      const focused = same4 ? [...box4.children].indexOf(
        /** @type {any} */
        document.activeElement
      ) : -1;
      box4.dataset.name = name;
      box4.replaceChildren(...rows2.map(row3));
      if (more2) box4.append(element("div", "muted selection-more", `and ${more2} more`));
      box4.scrollTop = top;
      if (focused >= 0) childrenOf(box4)[focused]?.focus({ preventScroll: true });
      return clientside.no_update;
    }
  });

  // motifs/names.mjs
  var LONGEST = 26;
  var short = (text) => text.length > LONGEST ? text.slice(0, LONGEST - 1) + "…" : text;
  register("names", {
    /** @param {Record<string, string[]> | null} names */
    async draw(names2) {
      const cy = await graphReady();
      if (!cy) return clientside.no_update;
      cy.batch(() => cy.nodes("[motif >= 0]").forEach((node) => {
        if (node.data("plain") === void 0) node.data("plain", node.data("label"));
        const [name] = (names2 || {})[node.data("motif")] || [];
        const label = name ? `${short(name)} · ${node.data("plain").split(" · ").pop()}` : node.data("plain");
        if (node.data("label") !== label) node.data("label", label);
      }));
      return clientside.no_update;
    },
    // Rows that do not match leave the table, their boxes fade in the graph.
    /** @param {string | null} text @param {Record<string, any>[] | null} rows */
    async search(text, rows2) {
      const words4 = (text || "").toLowerCase().split(/\s+/).filter(Boolean);
      const api = await gridApi(MOTIF_TABLE);
      if (api) api.setGridOption("quickFilterText", text || "");
      const cy = await graphReady(3);
      if (!cy) return clientside.no_update;
      const fits2 = (row7) => {
        const all = ["id", "name", "tags", "note", "label"].map((field) => row7[field] ?? "").join(" ").toLowerCase();
        return words4.every((word) => all.includes(word));
      };
      const matching2 = new Set((rows2 || []).filter(fits2).map((row7) => "m" + row7.id));
      cy.batch(() => cy.nodes("[motif >= 0]").forEach((node) => {
        node.toggleClass("unmatched", words4.length > 0 && !matching2.has(node.id()));
      }));
      return clientside.no_update;
    }
  });

  // motifs/stability.mjs
  var shown6 = null;
  var of = (motif) => shown6?.motifs[motif ?? ""];
  function rate(node) {
    const shares2 = of(node.data("motif"));
    if (!shares2) return;
    const label = `${node.data("label")} · ${percent(shares2.overall)}`;
    if (node.data("rated") !== label) node.data({ rated: label, stability: shares2.overall });
    node.addClass("rated");
  }
  var watched3 = /* @__PURE__ */ new WeakSet();
  function watch4(cy) {
    if (watched3.has(cy)) return;
    watched3.add(cy);
    cy.on("data", "node[motif >= 0]", (event) => rate(event.target));
  }
  function words3(motif) {
    const shares2 = of(motif);
    if (!shares2) return "Choose a box to see how it fared.";
    const kinds2 = [["noise", "with noise"], ["seed", "from other seeds"], ["parameters", "with settings a step away"]];
    const each = kinds2.filter(([kind]) => kind in shares2).map(([kind, name]) => `${percent(shares2[kind] ?? 0)} ${name}`);
    return `Motif ${motif}: ${percent(shares2.overall)}, kept in ${shares2.kept} of ${shown6?.repeats} repeats (${each.join(", ")}).`;
  }
  gridFunctions.stabilityOf = (params) => (params.data && of(params.data.id)?.overall) ?? null;
  register("stability", {
    /** @param {Stability | null} data @param {unknown} _elements @param {Selection | null} selection */
    async draw(data2, _elements, selection) {
      shown6 = data2 || null;
      const legend5 = find(STABILITY_LEGEND);
      if (legend5) legend5.classList.toggle("hidden", !shown6);
      const place5 = find(STABILITY_WORDS);
      if (place5 && shown6) place5.textContent = words3((selection || {}).motif);
      const cy = await graphReady();
      if (!cy) return clientside.no_update;
      watch4(cy);
      cy.batch(() => {
        if (shown6) cy.nodes("[motif >= 0]").forEach(rate);
        else cy.nodes(".rated").removeClass("rated");
      });
      return clientside.no_update;
    },
    /** @param {Stability | null} data */
    async list(data2) {
      shown6 = data2 || null;
      const api = await gridApi(MOTIF_TABLE);
      if (!api) return clientside.no_update;
      api.setColumnsVisible(["stability"], Boolean(shown6));
      api.refreshCells({ columns: ["stability"], force: true });
      return clientside.no_update;
    }
  });

  // motifs/timeline.mjs
  var place = (node, start3, end, seconds) => {
    node.style.left = 100 * start3 / seconds + "%";
    node.style.width = Math.max(100 * (end - start3) / seconds, 0.15) + "%";
  };
  function labelBlock([start3, end, action], { actions: actions4, colours }, seconds) {
    const block2 = element("span", "timeline-label", actions4[action]);
    block2.title = `${actions4[action]}, ${clock(start3)} to ${clock(end)}`;
    block2.style.setProperty("--tone", colours[action]);
    place(block2, start3, end, seconds);
    return block2;
  }
  function motionBlock([start3, end, motif, number2], motifs2, seconds) {
    const { name, colour: tone, motions: motions2 } = motifs2[motif];
    const block2 = element("button", "timeline-motion");
    block2.append(element("span", motif < 100 ? "" : "timeline-hundred", String(motif)));
    block2.type = "button";
    block2.tabIndex = -1;
    block2.title = `${name}, motion ${number2 + 1} of ${motions2}, ${clock(start3)} to ${clock(end)}`;
    block2.setAttribute("aria-label", block2.title);
    block2.dataset.store = SELECTION;
    block2.dataset.value = JSON.stringify({ motif, motion: number2 });
    block2.dataset.motif = String(motif);
    block2.style.setProperty("--tone", tone);
    place(block2, start3, end, seconds);
    return block2;
  }
  function row4(clip, data2, longest2, fill) {
    const line3 = element("div", "timeline-row");
    line3.setAttribute("role", "listitem");
    const head3 = element("button", "timeline-clip");
    head3.type = "button";
    head3.title = `Play ${clip.clip}`;
    head3.setAttribute("aria-label", `${head3.title}, ${Math.round(100 * clip.share)} % in motifs`);
    head3.dataset.store = SELECTION;
    head3.dataset.value = JSON.stringify({ clip: clip.clip });
    head3.append(element("span", "ellipsis", clip.brief), element("span", "muted number", `${Math.round(100 * clip.share)} %`));
    const track = element("div", "timeline-track");
    const time = element("div", "timeline-time");
    time.style.width = fill ? "100%" : Math.max(100 * clip.seconds / longest2, 0.5) + "%";
    time.dataset.clip = clip.clip;
    time.dataset.seconds = String(clip.seconds);
    time.dataset.fps = String(clip.fps);
    if (data2.actions.length) {
      const labels2 = element("div", "timeline-labels");
      labels2.append(...clip.labels.map((label) => labelBlock(label, data2, clip.seconds)));
      time.append(labels2);
    }
    const motions2 = element("div", "timeline-motions");
    motions2.append(...clip.motions.map((motion) => motionBlock(motion, data2.motifs, clip.seconds)));
    if (childrenOf(motions2)[0]) childrenOf(motions2)[0].tabIndex = 0;
    time.append(motions2, element("div", "timeline-now"));
    track.append(time);
    line3.append(head3, track);
    return line3;
  }
  function ordered(rows2, order, motif) {
    const has = ({ motions: motions2 }) => motions2.filter((motion) => String(motion[2]) === String(motif)).length;
    if (order === "share") return [...rows2].sort((a, b) => a.share - b.share);
    if (order === "chosen") return [...rows2].sort((a, b) => has(b) - has(a));
    return rows2;
  }
  function legend4(box4, { actions: actions4, colours }) {
    box4.replaceChildren(...actions4.slice(0, 24).map((action, i) => {
      const entry = element("span", "timeline-key", action);
      entry.style.setProperty("--tone", colours[i]);
      return entry;
    }));
    if (actions4.length > 24) box4.append(element("span", "muted", `and ${actions4.length - 24} more`));
  }
  function mark2(box4, selection) {
    chosen2 = selection;
    const motif = selection && selection.motif !== void 0 ? String(selection.motif) : null;
    box4.classList.toggle("one-motif", motif !== null);
    for (const block2 of allWithin(box4, ".timeline-motion")) {
      block2.classList.toggle("same", block2.dataset.motif === motif);
      const { motion } = JSON.parse(block2.dataset.value ?? "{}");
      block2.setAttribute("aria-pressed", String(block2.dataset.motif === motif && String(selection?.motion) === String(motion)));
    }
    for (const head3 of allWithin(box4, ".timeline-clip")) {
      head3.classList.toggle("chosen", Boolean(selection && selection.clip === JSON.parse(head3.dataset.value ?? "{}").clip));
    }
  }
  function move2(event) {
    const block2 = closest(event, ".timeline-motion");
    if (!block2) return;
    const motions2 = (
      /** @type {HTMLInputElement} */
      block2.parentNode
    );
    const siblings = childrenOf(motions2);
    const lines2 = allWithin(around(block2, ".timeline-rows"), ".timeline-motions:not(:empty)");
    const at3 = siblings.indexOf(block2);
    const line3 = lines2.indexOf(motions2);
    const ways = {
      ArrowRight: () => siblings[at3 + 1],
      ArrowLeft: () => siblings[at3 - 1],
      ArrowDown: () => lines2[line3 + 1] && childrenOf(lines2[line3 + 1])[0],
      ArrowUp: () => lines2[line3 - 1] && childrenOf(lines2[line3 - 1])[0]
    };
    const next2 = ways[event.key];
    if (!next2) return;
    event.preventDefault();
    event.stopPropagation();
    next2()?.focus();
  }
  document.addEventListener("keydown", move2);
  var shown7 = [];
  function cursor() {
    const box4 = find(TIMELINE_ROWS);
    if (!box4 || !box4.offsetParent) return;
    const now6 = /* @__PURE__ */ new Map();
    for (let i = 0; i < 24; i++) {
      const item = player.frameOf(i);
      if (!item) break;
      if (!String(item.dataset || "").startsWith("~")) now6.set(item.clip, item.frame);
    }
    for (const line3 of shown7) if (!now6.has(line3.parentElement?.dataset.clip ?? "")) line3.style.display = "";
    shown7 = [];
    for (const [clip, frame] of now6) {
      const time = allWithin(box4, `.timeline-time[data-clip="${CSS.escape(clip)}"]`)[0];
      const line3 = time && childrenOf(time).at(-1);
      if (!line3) continue;
      line3.style.display = "block";
      line3.style.left = 100 * frame / Number(time.dataset.fps) / Number(time.dataset.seconds) + "%";
      shown7.push(line3);
    }
  }
  setInterval(cursor, 80);
  var drawn3 = null;
  function drawing4(selection) {
    if (!drawn3) return null;
    const motif = selection && selection.motif !== void 0 ? { motif: String(selection.motif) } : null;
    const scheme = document.documentElement.dataset.mantineColorScheme || "light";
    return `${drawn3.data.drawing}&${new URLSearchParams({ order: drawn3.order, scale: drawn3.scale, ...motif, scheme })}`;
  }
  var chosen2 = null;
  drawings.timeline = () => drawing4(chosen2);
  function draw6(data2, order, scale3, selection) {
    const box4 = find(TIMELINE_ROWS);
    if (!box4 || !data2) return clientside.no_update;
    const wanted2 = { data: data2, order, scale: scale3, motif: order === "chosen" ? (selection || {}).motif : null };
    const same4 = drawn3 && box4.firstChild && data2 === drawn3.data && order === drawn3.order && scale3 === drawn3.scale && wanted2.motif === drawn3.motif;
    if (!same4) {
      drawn3 = wanted2;
      const longest2 = Math.max(...data2.rows.map((clip) => clip.seconds), 1e-3);
      const rows2 = ordered(data2.rows, order, (selection || {}).motif);
      box4.classList.toggle("labelled", data2.actions.length > 0);
      box4.replaceChildren(...rows2.map((clip) => row4(clip, data2, longest2, scale3 === "fill")));
      legend4(need(TIMELINE_LEGEND), data2);
    }
    mark2(box4, selection);
    return clientside.no_update;
  }
  register("timeline", {
    draw: draw6,
    /** @param {Selection | null} selection @param {string} order */
    mark(selection, order) {
      if (drawn3 && order === "chosen") draw6(drawn3.data, order, drawn3.scale, selection);
      const box4 = find(TIMELINE_ROWS);
      if (box4) mark2(box4, selection);
      return clientside.no_update;
    }
  });

  // shared/skate_meter.mjs
  function drawSkateMeter(box4, label, quality, blended = true) {
    box4.classList.toggle("hidden", !quality?.skate);
    if (!quality?.skate) return;
    const [source, plain3, kept] = quality.skate;
    const most = Math.max(source, plain3, kept, 1e-6);
    const title = element("div", "walk-meter-title", "Foot skate");
    title.title = "How far standing feet slide, in centimetres per second of contact";
    const rows2 = [[label, kept], ["Blending alone", plain3], ["Recordings", source]];
    const meters = rows2.map(([name, value], i) => {
      const bar = element("span", "walk-bar");
      bar.style.setProperty("--share", String(value / most));
      const number2 = element("span", "number", `${(100 * value).toFixed(1)} cm/s`);
      return element("div", i ? "walk-meter" : "walk-meter walk-meter-own", element("span", "", name), bar, number2);
    });
    const [blends, recordings] = quality.speeds;
    const words4 = blended ? `${quality.jump ? "A blend jumps" : "No jump"}: fastest joint ${blends} m/s in the blends, ${recordings} m/s in the recordings.` : "Recorded as it is: nothing had to be blended.";
    box4.replaceChildren(title, ...meters, element("div", quality.jump ? "walk-speed walk-jump" : "walk-speed", words4));
  }

  // motifs/walk_graph.mjs
  var watched4 = /* @__PURE__ */ new WeakSet();
  function watch5(cy, steps2) {
    if (watched4.has(cy)) return;
    watched4.add(cy);
    cy.on("tap", "node", (event) => walking.on && steps2.add(event.target.data("motif")));
    cy.on("tap", "edge", (event) => {
      if (!walking.on) return;
      steps2.follow(event.target.source().data("motif"), event.target.target().data("motif"));
    });
  }
  var further = ([source, target2]) => ({
    group: "edges",
    classes: "further",
    selectable: false,
    data: { id: `w${source}-${target2}`, source: `m${source}`, target: `m${target2}`, width: 2.5 }
  });
  var turn2 = 0;
  async function markWalk(data2, on2, steps2) {
    const mine2 = ++turn2;
    const cy = await graphReady(on2 ? 100 : 1);
    if (!cy || mine2 !== turn2) return;
    watch5(cy, steps2);
    const links = new Set((data2.path || []).slice(1).map((motif, i) => `${data2.path?.[i]}-${motif}`));
    const wanted2 = on2 ? (data2.further || []).filter(([a, b]) => cy.getElementById(`m${a}`).nonempty() && cy.getElementById(`m${b}`).nonempty()) : [];
    const kept = new Set(wanted2.map(([a, b]) => `w${a}-${b}`));
    cy.batch(() => {
      cy.edges(".further").filter((edge) => !kept.has(edge.id())).remove();
      cy.add(wanted2.filter(([a, b]) => cy.getElementById(`w${a}-${b}`).empty()).map(further));
      cy.nodes().forEach((node) => {
        node.toggleClass("walked", on2 && (data2.path || []).includes(node.data("motif")));
        node.toggleClass("dead-end", on2 && (data2.dead || []).includes(node.data("motif")));
      });
      cy.edges().forEach((edge) => {
        edge.toggleClass("walked", on2 && links.has(edge.id().slice(1)));
      });
      if (!on2) cy.nodes(".lit").removeClass("lit");
    });
  }
  async function lightMotif(motif) {
    const cy = await graphReady(1);
    if (!cy) return;
    cy.batch(() => {
      cy.nodes(".lit").removeClass("lit");
      if (motif !== null) cy.getElementById(`m${motif}`).addClass("lit");
    });
  }

  // motifs/walk_path.mjs
  var path = {
    ids: (
      /** @type {number[]} */
      []
    ),
    actions: (
      /** @type {PathActions} */
      /** @type {any} */
      null
    ),
    focus: (
      /** @type {number | undefined} */
      void 0
    )
  };
  var LINKS = { further: "A further transition point, inside the motions", bridge: "Bridged by a blend: not in the recordings" };
  function moved(ids, from, to) {
    const next2 = [...ids];
    next2.splice(to, 0, ...next2.splice(from, 1));
    return next2;
  }
  var without = (ids, at3) => ids.filter((_, i) => i !== at3);
  function chip(motif, at3, data2, actions4) {
    const name = data2.motifs?.find((one) => one.id === motif)?.name || "";
    const item = element("li", "walk-step");
    const kind = data2.kinds?.[at3 - 1];
    if (at3 && kind && kind !== "seen") {
      const mark3 = element("span", "walk-link", "⇢");
      mark3.title = LINKS[kind];
      item.append(mark3);
    }
    const box4 = element("span", "walk-chip");
    box4.draggable = true;
    box4.dataset.at = String(at3);
    if (data2.gap && at3 && data2.path[at3 - 1] === data2.gap[0] && motif === data2.gap[1]) box4.classList.add("gap");
    if (data2.dead?.includes(motif) && at3 === data2.path.length - 1) box4.classList.add("dead");
    const go = element("button", "walk-go");
    go.type = "button";
    go.append(element("b", "", String(motif)));
    if (name) go.append(element("span", "walk-name", name));
    go.title = `Motif ${motif}${name ? `, ${name}` : ""}: play from here. Alt and arrow keys move it, Delete takes it away.`;
    go.addEventListener("click", () => actions4.jump(at3));
    go.addEventListener("keydown", (event) => {
      const ids = data2.path;
      const step3 = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (event.altKey && step3 && at3 + step3 >= 0 && at3 + step3 < ids.length) {
        path.focus = at3 + step3;
        actions4.write(moved(ids, at3, at3 + step3));
      } else if (event.key === "Delete" || event.key === "Backspace") {
        path.focus = Math.max(0, at3 - 1);
        actions4.write(without(ids, at3));
      } else return;
      event.preventDefault();
      event.stopPropagation();
    });
    const away = element("button", "walk-away", "×");
    away.type = "button";
    away.title = "Take away";
    away.setAttribute("aria-label", `Take motif ${motif} away`);
    away.addEventListener("click", () => actions4.write(without(data2.path, at3)));
    box4.append(go, away);
    item.append(box4);
    return item;
  }
  function watch6(list3) {
    if (list3.dataset.watched) return;
    list3.dataset.watched = "yes";
    let held2 = null;
    const place5 = (event) => closest(event, ".walk-chip");
    list3.addEventListener("dragstart", (event) => {
      held2 = Number(place5(event)?.dataset.at);
      if (!event.dataTransfer) return;
      event.dataTransfer.effectAllowed = "move";
      event.dataTransfer.setData("text/plain", String(held2));
    });
    list3.addEventListener("dragover", (event) => {
      if (held2 === null || !place5(event)) return;
      event.preventDefault();
      for (const box4 of allWithin(list3, ".walk-chip")) box4.classList.toggle("over", box4 === place5(event));
    });
    list3.addEventListener("drop", (event) => {
      const to = place5(event);
      if (held2 === null || !to) return;
      event.preventDefault();
      if (Number(to.dataset.at) !== held2) path.actions.write(moved(path.ids, held2, Number(to.dataset.at)));
    });
    list3.addEventListener("dragend", () => {
      held2 = null;
      for (const box4 of allWithin(list3, ".over")) box4.classList.remove("over");
    });
  }
  function drawPath(list3, data2, actions4) {
    watch6(list3);
    path.ids = data2.path || [];
    path.actions = actions4;
    const stamp = JSON.stringify([data2.path, data2.kinds, data2.gap, data2.dead, data2.motifs]);
    if (list3.dataset.stamp === stamp) return;
    list3.dataset.stamp = stamp;
    list3.replaceChildren(...path.ids.map((motif, at3) => chip(motif, at3, data2, actions4)));
    const focused = path.focus === void 0 ? null : allWithin(list3, ".walk-go")[path.focus];
    path.focus = void 0;
    if (focused) focused.focus();
  }
  function lightVisit(list3, visit) {
    if (!list3) return;
    allWithin(list3, ".walk-chip").forEach((box4, at3) => {
      const here3 = at3 === visit;
      box4.classList.toggle("lit", here3);
      if (here3) box4.setAttribute("aria-current", "true");
      else box4.removeAttribute("aria-current");
      if (here3) {
        const [outer, inner] = [list3.getBoundingClientRect(), box4.getBoundingClientRect()];
        if (inner.top < outer.top || inner.bottom > outer.bottom) list3.scrollTop += inner.top - outer.top - 4;
      }
    });
  }

  // motifs/walk_words.mjs
  var MOST_NAMED = 12;
  function waysText(data2) {
    if (!data2.parts) return "";
    const total3 = data2.motifs.length;
    const words4 = [];
    if (data2.parts.length > 1) words4.push(`From ${data2.parts[0]} of ${total3} motifs one can come back to each other; ${data2.parts.length - 1} more such part${data2.parts.length > 2 ? "s" : ""}.`);
    const dead = data2.dead.length > MOST_NAMED ? `${data2.dead.length} motifs` : data2.dead.join(", ");
    if (data2.dead.length) words4.push(`Dead ends, where nothing leads on: ${dead} (marked in the graph).`);
    if (data2.inputs.extra) words4.push(data2.further.length ? `${data2.further.length} further transitions (dashed).` : "No further transition points are good enough.");
    return words4.join(" ");
  }
  var filled = (path2, [a, b], detour) => path2.flatMap((motif, i) => i && path2[i - 1] === a && motif === b ? detour.slice(1) : [motif]);
  var withoutGap = (path2, [a, b]) => path2.filter((motif, i) => !(i && path2[i - 1] === a && motif === b));

  // motifs/walk.mjs
  var KEYS5 = ["walk", "extra", "gaps", "ends", "feet"];
  var OURS2 = "~walk~";
  var LONGEST2 = 300;
  var BEFORE = 0.5;
  var now2 = (
    /** @type {any} */
    {}
  );
  var view = {};
  var played = "";
  var added = false;
  var lit = -1;
  var keysOf2 = (shown9) => Object.fromEntries(KEYS5.filter((key) => shown9?.[key]).map((key) => [key, shown9?.[key]]));
  var same2 = (a, b) => KEYS5.every((key) => (a?.[key] || "") === (b?.[key] || ""));
  var onStage2 = () => Boolean(player.frameOf(0)?.dataset?.startsWith(OURS2));
  var motifs = () => now2.path || [];
  function write3(path2, more2 = {}) {
    const text = path2.join("-");
    if (text.length > LONGEST2) return problem({ error: "This path is too long for a link; about a hundred motifs fit." });
    changeView({ walk: text, ...more2 });
  }
  function add2(motif) {
    added = true;
    write3([...motifs(), motif]);
  }
  function request2(data2) {
    const shown9 = data2.path.slice(0, 8).join(" → ") + (data2.path.length > 8 ? " …" : "");
    return {
      dataset: data2.name ?? "",
      title: `Walk: ${shown9}`,
      layout: "overlay",
      sync: "start",
      items: [{ clip: "walk", start: 0, end: data2.frames, label: "Walk", colours: data2.bands }]
    };
  }
  async function play4(data2, fromEnd) {
    played = data2.name ?? "";
    await player.show(request2(data2));
    if (!fromEnd || data2.path.length < 2) return;
    const back = Math.round(BEFORE * data2.frames / data2.seconds);
    player.seek({ clip: "walk", frame: Math.max(0, (data2.visits.at(-1) ?? [0])[0] - back) });
  }
  var swap = (data2) => {
    played = data2.name ?? "";
    player.replace(request2(data2));
  };
  function problem({ error, gap, detour }) {
    const box4 = need(WALK_ERROR);
    box4.replaceChildren();
    box4.classList.toggle("hidden", !error);
    if (!error) return;
    const text = document.createElement("p");
    text.textContent = error;
    box4.append(text);
    const offer2 = (label, act2) => {
      const button5 = Object.assign(document.createElement("button"), { type: "button", className: "walk-button", textContent: label });
      button5.addEventListener("click", act2);
      box4.append(button5);
    };
    if (gap && detour?.length) offer2(`Go by way of ${detour.slice(1, -1).join(", ")}`, () => write3(filled(motifs(), gap, detour)));
    if (gap) offer2("Bridge the gap by a blend", () => changeView({ gaps: "bridge" }));
    if (gap && motifs().length) offer2(`Take ${gap[1]} away`, () => write3(withoutGap(motifs(), gap)));
  }
  function show3() {
    const busy = !same2(now2.inputs, keysOf2(view));
    need(WALK_PATH).classList.toggle("busy", busy);
    if (busy) {
      need(WALK_HINT).textContent = view.walk ? "Making the walk …" : "";
      return;
    }
    const walks = Boolean(now2.name);
    need(WALK_PATH).dataset.shown = now2.inputs.walk || "";
    need(WALK_LENGTH).textContent = walks ? `${now2.path.length} motif${now2.path.length > 1 ? "s" : ""}, ${now2.seconds.toFixed(1)} s` : "";
    need(WALK_HINT).textContent = walks || now2.error ? "" : "Click motifs in the graph one after the other, or let chance choose.";
    need(WALK_NOTES).replaceChildren(...(now2.warnings || []).map((text) => Object.assign(document.createElement("p"), { textContent: text })));
    need(WALK_WAYS).textContent = waysText(now2);
    drawPath(need(WALK_PATH), now2, { write: write3, jump: seekTo });
    problem(now2);
    drawSkateMeter(need(WALK_METERS), "This walk", now2.name ? now2 : null, now2.blends > 0);
    for (const button5 of allWithin(document, "[data-walk='play']")) button5.disabled = !walks;
    for (const button5 of allWithin(document, "[data-walk='clear']")) button5.disabled = !view.walk;
    setLink(WALK_BVH, walks && `/api/bvh/${encodeURIComponent(now2.name ?? "")}/walk`);
    const recipes = Object.values(walks && now2.recipes || {});
    allWithin(document, ".walk-recipe").forEach((button5, i) => {
      button5.disabled = !recipes[i];
      button5.title = `Copy the walk as ${i ? "a Python script" : "commands"}`;
      button5.dataset.copy = recipes[i] || "";
    });
    setLink(WALK_JSON, walks && `/api/walk/${now2.name?.slice(OURS2.length)}.json`);
    lists();
    markWalk(now2, walking.on, steps);
  }
  function lists() {
    for (const [id, first] of [[WALK_ADD, "a motif …"], [WALK_FROM, "motif"], [WALK_TO, "motif"]]) {
      const list3 = need(id);
      const stamp = `${now2.key} ${JSON.stringify(now2.motifs)}`;
      if (list3.dataset.stamp === stamp) continue;
      list3.dataset.stamp = stamp;
      const chosen3 = list3.value;
      list3.replaceChildren(new Option(first, ""), ...now2.motifs.map(({ id: motif, name }) => new Option(name ? `${motif} ${name}` : String(motif), String(motif))));
      list3.value = chosen3;
    }
  }
  function seekTo(visit) {
    if (!now2.name) return;
    const frame = now2.visits[visit][0];
    if (!onStage2() || played !== now2.name) play4(now2).then(() => player.seek({ clip: "walk", frame }));
    else player.seek({ clip: "walk", frame });
  }
  window.addEventListener("stage-frame", (event) => {
    const item = event.detail.items[0];
    const ours = walking.on && now2.name && item?.dataset === now2.name;
    const visit = ours ? now2.visits.findIndex(([a, b]) => item.frame >= a && item.frame < b) : -1;
    if (visit === lit) return;
    lit = visit;
    lightVisit(find(WALK_PATH), visit);
    lightMotif(visit < 0 ? null : now2.path[visit]);
  });
  var actions2 = {
    play: () => now2.name && play4(now2),
    clear: () => changeView({ walk: "" }),
    fewest: () => between("fewest"),
    used: () => between("used"),
    random() {
      const whole3 = (id, low, high) => Math.min(Math.max(Math.round(Number(need(id).value) || low), low), high);
      const seconds = whole3(WALK_SECONDS, 1, Number(need(WALK_SECONDS).max));
      let seed = whole3(WALK_SEED, 0, 999999999);
      if (view.walk === `random:${seconds}:${seed}`) seed += 1;
      changeView({ walk: `random:${seconds}:${seed}` });
    }
  };
  function between(by) {
    const [from, to] = [WALK_FROM, WALK_TO].map((id) => need(id).value);
    const missing = [WALK_FROM, WALK_TO].find((id) => !need(id).value);
    if (missing) return need(missing).focus();
    changeView({ walk: `${by}:${from}:${to}` });
  }
  document.addEventListener("click", (event) => {
    const button5 = closest(event, "[data-walk]");
    if (button5 && !button5.disabled && walking.on) actions2[button5.dataset.walk ?? ""]();
  });
  document.addEventListener("change", (event) => {
    if (targetOf(event).id !== WALK_ADD || !targetOf(event).value) return;
    add2(Number(targetOf(event).value));
    targetOf(event).value = "";
  });
  function leave2(selection) {
    if (!walking.on) return;
    walking.on = false;
    lit = -1;
    markWalk({}, false, steps);
    if (onStage2() && selection && Object.keys(selection).length) setStore(SELECTION, { ...selection });
  }
  var steps = {
    add: add2,
    /**
     * A click on an edge: on to its target, if the path has come to its source.
     * @param {number} source
     * @param {number} target
     */
    follow(source, target2) {
      const last3 = motifs().at(-1);
      if (last3 === source) add2(target2);
      else if (last3 === void 0) {
        added = true;
        write3([source, target2]);
      }
    }
  };
  ahead.unless((selection) => walking.on && (selection.edge !== void 0 || selection.motif !== void 0 && selection.motion === void 0));
  var OPTIONS = [["extra", WALK_EXTRA], ["gaps", WALK_BRIDGE], ["ends", WALK_STOP], ["feet", WALK_FEET]];
  var checkedFor = {
    /** @param {string | undefined} v */
    extra: (v) => v === "1",
    /** @param {string | undefined} v */
    gaps: (v) => v === "bridge",
    /** @param {string | undefined} v */
    ends: (v) => v === "stop",
    /** @param {string | undefined} v */
    feet: (v) => v !== "0"
  };
  register("walk", {
    /**
     * @param {Walk | null} data
     * @param {View | null} shown
     * @param {unknown} _id
     * @param {unknown} _elements
     * @param {Selection | null} selection
     */
    draw(data2, shown9, _id, _elements, selection) {
      view = shown9 || {};
      if (view.side !== "walk") return leave2(selection), clientside.no_update;
      if (!find(WALK_PATH)) return clientside.no_update;
      const entered = !walking.on;
      walking.on = true;
      for (const [key, id] of OPTIONS) clientside.set_props(id, { checked: checkedFor[key](view[key]) });
      const [, seconds, seed] = /^random:([\d.]+):(\d+)/.exec(view.walk || "") || [];
      if (seed) {
        clientside.set_props(WALK_SECONDS, { value: Number(seconds) });
        clientside.set_props(WALK_SEED, { value: Number(seed) });
      }
      if (!data2) return clientside.no_update;
      const before2 = now2;
      now2 = data2;
      show3();
      if (!now2.name || !same2(now2.inputs, keysOf2(view))) return clientside.no_update;
      const chosen3 = selection && Object.keys(selection).length > 0;
      if (entered && chosen3 && !before2.key) return clientside.no_update;
      if (entered && chosen3) setStore(SELECTION, {});
      if (now2.name !== played || entered && !onStage2()) {
        const feet = before2.name && before2.frames === now2.frames && String(before2.path) === String(now2.path) && onStage2();
        if (feet) swap(now2);
        else play4(now2, added && !entered);
      }
      added = false;
      return clientside.no_update;
    },
    // One of the switches: it goes into the link, where it differs.
    /**
     * @param {boolean} extra
     * @param {boolean} bridge
     * @param {boolean} stop
     * @param {boolean} feet
     * @param {View | null} shown
     */
    option(extra, bridge, stop, feet, shown9) {
      if (!walking.on) return clientside.no_update;
      const wanted2 = { extra: extra ? "1" : "", gaps: bridge ? "bridge" : "", ends: stop ? "stop" : "", feet: feet ? "" : "0" };
      if (OPTIONS.some(([key]) => (shown9?.[key] || "") !== wanted2[key])) changeView(wanted2);
      return clientside.no_update;
    }
  });

  // motion_map/state.mjs
  var none = null;
  var state = {
    map: (
      /** @type {MapData} */
      none
    ),
    known: (
      /** @type {KnownMap} */
      none
    ),
    keys: (
      /** @type {number[]} */
      []
    ),
    // nodes
    reach: 0,
    // metres that keys grow
    pace: (
      /** @type {Pace | null} */
      null
    ),
    facts: (
      /** @type {Facts | null} */
      null
    ),
    mode: "keys",
    // what a click does
    selection: (
      /** @type {Selection | null} */
      null
    ),
    hits: (
      /** @type {Hit[]} */
      []
    ),
    path: "",
    // one drawn by hand
    lit: (
      /** @type {number[]} */
      []
    ),
    shownOn: (
      /** @type {string | null} */
      null
    ),
    // key of the map on which keys and reach were shown last
    overlay: (
      /** @type {Overlay} */
      none
    ),
    // over the heatmap of the page, with its follower
    follower: (
      /** @type {Follower} */
      none
    )
  };

  // motion_map/export.mjs
  var LOOK = ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-opacity", "stroke-dasharray", "font", "text-anchor"];
  function copied(source) {
    const copy2 = (
      /** @type {SVGElement} */
      source.cloneNode(true)
    );
    const from = [source, ...allWithin(source, "*")], to = [copy2, ...allWithin(copy2, "*")];
    from.forEach((node, k) => {
      const style = getComputedStyle(node);
      for (const name of LOOK) if (style.getPropertyValue(name)) to[k].style.setProperty(name, style.getPropertyValue(name));
      to[k].setAttribute("vector-effect", "non-scaling-stroke");
    });
    copy2.querySelector(".map-layer-cursor")?.remove();
    return copy2;
  }
  async function drawing5() {
    const { overlay } = state, plot = within(overlay.box, ".js-plotly-plot");
    const { width, height } = plot.getBoundingClientRect();
    const address3 = await window.Plotly.toImage(plot, { format: "svg", width, height });
    const text = decodeURIComponent(address3.slice(address3.indexOf(",") + 1));
    const page2 = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
    const ground = getComputedStyle(document.documentElement).getPropertyValue("--surface");
    page2.prepend(svgElement("rect", { width: "100%", height: "100%", fill: ground.trim() }));
    page2.append(copied(overlay.view));
    return new XMLSerializer().serializeToString(page2);
  }
  document.addEventListener("click", async (event) => {
    const button5 = closest(event, "[data-map-save]");
    if (!button5 || !state.map) return;
    const made = await drawing5(), name = `${state.known.dataset} map`;
    if (button5.dataset.mapSave === "svg") save(made, `${name}.svg`, "image/svg+xml");
    else save(await pngOf(made), `${name}.png`);
  });

  // search/by_words.mjs
  addPlaces((text) => {
    const words4 = text.trim();
    const dataset2 = new URLSearchParams(location.search).get("dataset");
    if (words4.length < 3 || !dataset2) return [];
    const query2 = new URLSearchParams({ dataset: dataset2, look: "words", words: words4 });
    return [{ name: `Find “${words4}” in the motion`, about: "search by words", address: `/search?${query2}` }];
  });

  // search/ids.mjs
  var SEARCH_ERROR = "search-error";
  var SEARCH_HITS_HEAD = "search-hits-head";
  var SEARCH_HITS = "search-hits";
  var SEARCH_SOURCES = "search-sources";
  var SEARCH_CLIP_NAMES = "search-clip-names";
  var SEARCH_MOTIF = "search-motif";
  var SEARCH_WARNING = "search-warning";
  var SEARCH_COUNTS = "search-counts";
  var SEARCH_COUNTS_SAYS = "search-counts-says";
  var SEARCH_WANTED = "search-wanted";
  var SEARCH_BODY = "search-body";
  var SEARCH_OPTIONS = "search-options";
  var SEARCH_PRESET = "search-preset";
  var SEARCH_ENGINE = "search-engine";
  var SEARCH_LEVEL = "search-level";
  var SEARCH_ROUTE = "search-route";
  var SEARCH_LABEL = "search-label";
  var SEARCH_NAMED = "search-named";
  var SEARCH_SHORTEST = "search-shortest";
  var SEARCH_LONGEST = "search-longest";
  var SEARCH_TYPED = (
    /** @type {StoreId<string>} */
    "search-typed"
  );
  var SEARCH_UPLOAD = (
    /** @type {StoreId<Upload>} */
    "search-upload"
  );
  var SEARCH_UPLOAD_STATUS = "search-upload-status";
  var STUDY_SETUP = "study-setup";
  var STUDY_RATE = "study-rate";
  var STUDY_VOTE = "study-vote";
  var STUDY_NAME = "study-name";
  var STUDY_ANSWER = (
    /** @type {StoreId<Answers>} */
    "study-answer"
  );
  var STUDY_WISH = (
    /** @type {StoreId<Wish>} */
    "study-wish"
  );
  var STUDY_PERSON = (
    /** @type {StoreId<Person>} */
    "study-person"
  );

  // search/study.mjs
  var SCALE = ["completely different", "", "", "", "", "", "", "", "", "identical"];
  var CHOICES = { left: ["A", "#3a9b7a", "A"], same: ["No difference", "", "S"], right: ["B", "#d2762b", "B"] };
  var VALUES = { A: "left", S: "same", B: "right" };
  var data = (
    /** @type {any} */
    null
  );
  var view2 = {};
  var at2 = { rate: 0, vote: 0 };
  var shown8 = "";
  var mode = () => view2.study === "vote" ? "vote" : view2.study === "results" ? "results" : "rate";
  var awaited = () => data.inputs.person !== (person2.name || person2.id);
  var rows = () => awaited() ? [] : (mode() === "vote" ? data.duels : data.pairs) || [];
  var visible = () => Boolean(find(STUDY_SETUP)?.offsetParent) && data && !data.error;
  var button3 = (words4, name, className = "search-button") => {
    const made = element("button", className, ...[words4].flat());
    made.type = "button";
    made.dataset.study = name;
    return made;
  };
  function setup() {
    const queries = data.queries.map(({ name: name2, clip, when, strip }) => {
      const picture2 = element("img", "study-strip");
      Object.assign(picture2, { src: strip, alt: "", draggable: false });
      const away = button3(icon("close", 12), "remove", "search-tool");
      away.dataset.name = name2;
      away.title = `Leave ${clip} out`;
      away.setAttribute("aria-label", away.title);
      return element("div", "study-query", picture2, element("span", "study-query-words", element("b", "ellipsis", clip), element("span", "muted", when)), away);
    });
    const engines = data.engines.map(({ method, label: label2, ready: ready2 }) => {
      if (ready2) return element("span", "study-engine", icon("check", 13), label2);
      const build3 = button3(`Build ${label2}`, "build");
      build3.dataset.method = method;
      build3.title = "Its index has not been built yet; then it takes part";
      return build3;
    });
    const name = element("input", "search-text");
    Object.assign(name, { id: STUDY_NAME, placeholder: "optional", maxLength: 60, value: person2.name || "", autocomplete: "off" });
    const label = element("label", "search-label", "Your name");
    label.htmlFor = STUDY_NAME;
    const add3 = button3([icon("plus", 13), "The query of the search"], "add");
    add3.disabled = !whole();
    add3.title = whole() ? "" : "Choose a query of this dataset, for the whole body, under Search first";
    need(STUDY_SETUP).replaceChildren(
      element("div", "study-line", element("span", "search-label", "Queries"), ...queries, add3, button3([icon("dice", 15), "Draw three"], "draw")),
      element("div", "study-line", element("span", "search-label", "Engines"), ...engines),
      element("div", "study-line", label, name)
    );
  }
  function whole() {
    const text = view2.query || "";
    return text && !text.includes(",") && text.split(":").length === 2 ? text : "";
  }
  function nothing(words4) {
    return element("p", "muted study-nothing", words4);
  }
  function draw7() {
    const which = mode();
    if (which === "results") return;
    const box4 = need(which === "vote" ? STUDY_VOTE : STUDY_RATE);
    const all = rows();
    if (awaited()) return box4.replaceChildren(nothing(`Fetching the pairs for ${person2.name || "you"} …`));
    if (!data.queries.length) return box4.replaceChildren(nothing("Choose queries above: the one of the search, or three drawn by chance."));
    if (!all.length) {
      const built = data.engines.filter((engine) => engine.ready).length;
      return box4.replaceChildren(nothing(!built ? "Build the index of at least one engine first." : which === "vote" ? "There are too few hits to compare." : "The engines found nothing for these queries."));
    }
    at2[which] = Math.min(at2[which], all.length - 1);
    const row7 = all[at2[which]];
    const done = all.filter((one) => one.value).length;
    const bar = element("div", "job-progress", element("div"));
    childrenOf(bar)[0].style.width = `${100 * done / all.length}%`;
    const walk2 = element("div", "study-walk", move3("Back", -1, "back"), element("span", "muted number", `${at2[which] + 1} of ${all.length}, ${done} answered`), move3("Skip", 1, "next"));
    box4.replaceChildren(
      element("div", "study-progress", bar),
      element("h2", "study-question", which === "vote" ? "Which is more like the query: A or B?" : "How alike are the two motions on the Stage?"),
      which === "vote" ? choices(row7) : scale2(row7),
      walk2,
      ...done === all.length ? [element("p", "study-thanks", "All pairs are answered. Thank you! Results shows what came of it.")] : []
    );
    play5(row7);
    return void 0;
  }
  function move3(words4, by, symbol) {
    const made = button3([icon(symbol, 13), words4], "move");
    made.dataset.by = String(by);
    return made;
  }
  function scale2(row7) {
    const buttons = SCALE.map((words4, k) => {
      const one = button3([element("b", "", String(k + 1)), element("span", "", words4)], "answer", "study-value");
      one.dataset.value = String(k + 1);
      one.setAttribute("aria-label", `${k + 1}${words4 ? `: ${words4}` : ""}`);
      one.setAttribute("aria-pressed", String(row7.value === k + 1));
      return one;
    });
    const keys = element("p", "muted study-keys", "Keys 1 to 9, and 0 for 10; Backspace goes back, N skips.");
    return element("div", "", element("div", "study-scale", ...buttons), keys);
  }
  function choices(row7) {
    const buttons = Object.entries(CHOICES).map(([value, [words4, colour, key]]) => {
      const dot3 = element("span", "study-dot");
      dot3.style.background = colour;
      const one = button3([...colour ? [dot3] : [], element("b", "", words4), element("kbd", "", key)], "answer", "study-choice");
      one.dataset.value = value;
      one.setAttribute("aria-pressed", String(row7.value === value));
      return one;
    });
    return element("div", "study-choices", ...buttons);
  }
  function play5(row7) {
    const wanted2 = JSON.stringify([row7.query, row7.hit, row7.left, row7.right]);
    if (wanted2 === shown8 && player.status !== "empty") return;
    shown8 = wanted2;
    setStore(SELECTION, {});
    setStore(STAGE_REQUEST, { ...row7.request, at: wanted2 });
    const next2 = rows()[at2[mode()] + 1];
    if (next2) setTimeout(() => player.prefetch(next2.request), 600);
  }
  function answer(value) {
    const which = mode();
    const row7 = rows()[at2[which]];
    if (!row7) return;
    row7.value = value;
    given.set(nameOf3(row7), value);
    const message2 = which === "vote" ? { kind: "vote", query: row7.query, left: row7.left, right: row7.right, choice: String(value) } : { kind: "rating", query: row7.query, hit: row7.hit, value: Number(value) };
    pending.push({ ...message2, person: person2.name || person2.id, id: `${Date.now()} ${Math.random()}` });
    send();
    step2(1);
  }
  function send() {
    if (!pending.length || !find(STUDY_RATE) || sent && Date.now() - sent < PATIENCE4) return;
    sent = Date.now();
    setStore(STUDY_ANSWER, { answers: [...pending], at: sent });
    setTimeout(send, PATIENCE4);
  }
  function step2(by) {
    const which = mode();
    at2[which] = Math.min(Math.max(at2[which] + by, 0), Math.max(rows().length - 1, 0));
    draw7();
  }
  var given = /* @__PURE__ */ new Map();
  var nameOf3 = (row7) => JSON.stringify([person2.name || person2.id, row7.query, row7.hit, row7.left, row7.right]);
  function place2(number2, before2, all) {
    const same4 = before2[number2] && before2.length === all.length && nameOf3(before2[number2]) === nameOf3(all[number2]);
    return same4 ? number2 : Math.max(all.findIndex((row7) => !row7.value), 0);
  }
  var PATIENCE4 = 2e4;
  var pending = [];
  var sent = 0;
  var person2 = {};
  function takePerson(stored) {
    person2 = stored || {};
    if (!person2.id) {
      person2 = { ...person2, id: `someone-${Math.random().toString(36).slice(2, 8)}` };
      setStore(STUDY_PERSON, person2);
    }
  }
  register("study", {
    /** @param {ReceivedAnswers | null} answers */
    received(answers) {
      if (!answers?.received) return clientside.no_update;
      for (const id of answers.received) {
        const number2 = pending.findIndex((one) => one.id === id);
        if (number2 >= 0) pending.splice(number2, 1);
      }
      sent = 0;
      send();
      return clientside.no_update;
    },
    /** @param {Study | null} found @param {View | null} seen @param {Person | null} stored */
    draw(found, seen3, stored) {
      view2 = seen3 || {};
      if (!found || view2.look !== "agree" || !find(STUDY_SETUP)) {
        shown8 = "";
        return clientside.no_update;
      }
      if (!stored || !stored.id) takePerson(stored);
      else person2 = stored;
      const fresh = found !== data;
      const before2 = data && data.inputs.person === found.inputs.person ? data : null;
      data = found;
      if (data.error) {
        need(STUDY_SETUP).replaceChildren(nothing(data.error));
        for (const id of [STUDY_RATE, STUDY_VOTE]) need(id).replaceChildren();
        return clientside.no_update;
      }
      if (fresh) for (const row7 of [...data.pairs, ...data.duels]) row7.value = given.get(nameOf3(row7)) ?? row7.value;
      if (fresh) for (
        const [which, all] of
        /** @type {["rate" | "vote", "pairs" | "duels"][]} */
        [["rate", "pairs"], ["vote", "duels"]]
      ) at2[which] = place2(at2[which], before2 && before2[all] || [], data[all]);
      setup();
      draw7();
      return clientside.no_update;
    }
  });
  var ACTS = {
    add: () => asks([...data.queries.map((query2) => query2.name), whole()]),
    /** @param {HTMLElement} on */
    remove: (on2) => asks(data.queries.map((query2) => query2.name).filter((name) => name !== on2.dataset.name)),
    draw: () => setStore(STUDY_WISH, { draw: 1 + Math.floor(Math.random() * 1e6) }),
    /** @param {HTMLElement} on */
    build: (on2) => setStore(STUDY_WISH, { build: on2.dataset.method, at: Date.now() }),
    clear() {
      if (!window.confirm("Remove all ratings and votes about this dataset, of all people?")) return;
      given.clear();
      pending.length = 0;
      for (const row7 of [...data.pairs, ...data.duels]) row7.value = null;
      setStore(STUDY_WISH, { clear: true, at: Date.now() });
    },
    /** @param {HTMLElement} on */
    move: (on2) => step2(Number(on2.dataset.by)),
    /** @param {HTMLElement} on */
    answer: (on2) => answer(mode() === "vote" ? on2.dataset.value ?? "" : Number(on2.dataset.value))
  };
  var asks = (names2) => changeView({ asks: [...new Set(names2.filter(Boolean))].join(",") });
  document.addEventListener("click", (event) => {
    const on2 = closest(event, "[data-study]");
    if (on2 && !on2.disabled) ACTS[on2.dataset.study ?? ""](on2);
  });
  document.addEventListener("change", (event) => {
    if (targetOf(event).id !== STUDY_NAME) return;
    takePerson({ ...person2, name: targetOf(event).value.trim() });
    setStore(STUDY_PERSON, person2);
    draw7();
  });
  document.addEventListener("keydown", (event) => {
    if (!visible() || mode() === "results" || !rows().length || event.ctrlKey || event.metaKey || event.altKey) return;
    if (closest(event, "input:not([type='radio']), textarea, select")) return;
    const key = event.key.toUpperCase();
    let done = true;
    if (mode() === "rate" && /^[0-9]$/.test(key)) answer(key === "0" ? 10 : Number(key));
    else if (mode() === "vote" && VALUES[key]) answer(VALUES[key]);
    else if (key === "BACKSPACE") step2(-1);
    else if (key === "N") step2(1);
    else done = false;
    if (!done) return;
    event.preventDefault();
    event.stopPropagation();
  }, true);

  // sweeps/ids.mjs
  var SWEEP_TABLE = "sweep-table";

  // sweeps/sweeps.mjs
  function open4(address3) {
    const { pathname, searchParams } = new URL(address3, location.origin);
    setStore(SELECTION, {});
    openPage(pathname, { [VIEW_CHANGE]: changeOfSettings("motifs", Object.fromEntries(searchParams)) });
    need(PAGE).scrollTo(0, 0);
  }
  var plain2 = (event) => !(event.button || event.metaKey || event.ctrlKey || event.shiftKey || event.altKey);
  cellRenderers.PointLink = (props) => props.data ? reactElement("a", { className: "text-link point-link", href: props.data.href, tabIndex: -1 }, props.value) : null;
  document.addEventListener("click", (event) => {
    const link2 = closest(event, "a.point-link");
    if (!link2 || !plain2(event)) return;
    event.preventDefault();
    event.stopPropagation();
    open4(
      /** @type {any} */
      link2.href
    );
  }, true);
  document.addEventListener("keydown", (event) => {
    const row7 = event.key === "Enter" && closest(event, `#${SWEEP_TABLE} .ag-row`);
    const link2 = row7 && row7.querySelector("a.point-link");
    if (!link2) return;
    event.preventDefault();
    event.stopPropagation();
    open4(
      /** @type {any} */
      link2.href
    );
  }, true);
  register("sweeps", {
    /** @param {{ points?: { customdata?: any }[] } | null} click */
    open(click) {
      const address3 = click && click.points && click.points[0] && click.points[0].customdata;
      if (typeof address3 === "string" && address3) open4(address3);
      return clientside.no_update;
    }
  });

  // grammar/ids.mjs
  var GRAMMAR_STRING = "grammar-string";
  var GRAMMAR_RULES = "grammar-rules";
  var PHRASE = "phrase-";
  var ACTION_CARDS = "action-cards";
  var ACTION_HINT = "action-hint";
  var ACTION_DETAIL = "action-detail";
  var ACTION_TITLE = "action-title";
  var ACTION_COUNT = "action-count";
  var ACTION_ALL = "action-all";
  var OCCURRENCES = "occurrences";
  var ROUTINE_LIST = "routine-list";
  var ROUTINE_TITLE = "routine-title";
  var ROUTINE_COUNT = "routine-count";
  var ROUTINE_PLAY = "routine-play";
  var ROUTINE_SVG = "routine-svg";
  var ROUTINE_TREE = "routine-tree";
  var COMPOSE_ERROR = "compose-error";
  var COMPOSE_STATUS = "compose-status";
  var COMPOSE_STRING = "compose-string";
  var COMPOSE_CHOSEN = "compose-chosen";
  var COMPOSE_OTHERS = "compose-others";
  var COMPOSE_TREE = "compose-tree";
  var COMPOSE_METERS = "compose-meters";
  var COMPOSE_WARNINGS = "compose-warnings";
  var COMPOSE_MOST = "compose-most";
  var COMPOSE_BVH = "compose-bvh";
  var COMPOSE_JSON = "compose-json";
  var COMPOSE_SVG = "compose-svg";
  var COMPOSE_SAVE = "compose-save";

  // grammar/state.mjs
  var state2 = { data: (
    /** @type {GrammarData} */
    {}
  ) };
  var actionOf = (id) => (state2.data.actions || [])[id] || { id, name: `Action ${id}`, short: String(id), colour: "#8793a3", count: 0, seconds: 0, named: 0 };
  var playsSelection = (button5, selection) => {
    button5.dataset.store = SELECTION;
    button5.dataset.value = JSON.stringify(selection);
    return button5;
  };
  var paintAction = (node, action) => {
    node.style.setProperty("--tone", action.colour);
    node.style.setProperty("--ink", action.ink || "#ffffff");
  };
  var actionChip = (id) => {
    const action = actionOf(id);
    const button5 = playsSelection(element("button", "action-chip", action.short), { action: id });
    button5.type = "button";
    if (action.hint) button5.append(element("span", "action-hint-word", action.hint));
    paintAction(button5, action);
    button5.title = `${action.name}: ${plural(action.count, "time")}`;
    button5.dataset.action = String(id);
    return button5;
  };
  var redraw = (box4, children) => {
    const focused = allWithin(box4, "button, input, [tabindex]").indexOf(
      /** @type {any} */
      document.activeElement
    );
    const top = box4.scrollTop;
    box4.replaceChildren(...children);
    box4.scrollTop = top;
    if (focused >= 0) allWithin(box4, "button, input, [tabindex]")[focused]?.focus({ preventScroll: true });
  };
  var isFresh = (box4, stamp) => {
    const text = typeof stamp === "string" ? stamp : JSON.stringify(stamp);
    if (box4.drawnFrom === text) return false;
    box4.drawnFrom = text;
    return true;
  };
  var downloadQuery = (view4, more2 = {}) => {
    const pairs = new URLSearchParams({ dataset: state2.data.dataset || "" });
    for (const [key, value] of Object.entries(view4 || {})) if (value && key.startsWith("grammar-")) pairs.set(key, value);
    for (const [key, value] of Object.entries(more2)) pairs.set(key, String(value));
    return pairs.toString();
  };

  // grammar/actions.mjs
  var ROWS = 60;
  function card(action) {
    const button5 = playsSelection(element("button", "action-card"), { action: action.id });
    button5.type = "button";
    button5.dataset.action = String(action.id);
    button5.style.setProperty("--tone", action.colour);
    button5.title = `Play all occurrences of ${action.name}`;
    const head3 = element("span", "action-head");
    head3.append(element("b", "ellipsis", action.name), element("span", "muted number", action.named ? String(action.id) : ""));
    const strip = element("img", "action-strip");
    Object.assign(strip, { src: action.strip, alt: "", loading: "lazy", draggable: false });
    const facts = element("span", "muted number action-facts");
    facts.append(element("span", "", `${plural(action.count, "time")}, ${action.seconds.toFixed(1)} s`));
    if (action.label) facts.append(element("span", "ellipsis action-label", action.label));
    button5.append(head3, strip, facts);
    return button5;
  }
  function occurrence([clip, start3, end, number2], id, chosen3) {
    const button5 = playsSelection(element("button", "occurrence" + (chosen3 ? " chosen" : "")), { action: id, segment: number2 });
    button5.type = "button";
    button5.title = `Play ${clip.clip}, ${clock(start3)} to ${clock(end)}`;
    button5.setAttribute("aria-pressed", String(chosen3));
    const strip = element("img", "occurrence-strip");
    const frames = new URLSearchParams({ start: String(Math.round(start3 * clip.fps)), end: String(Math.round(end * clip.fps)), n: "4", v: state2.data.version });
    strip.src = `/api/filmstrip/${encodeURIComponent(state2.data.dataset)}/${encodeURIComponent(clip.clip)}?${frames}`;
    Object.assign(strip, { alt: "", loading: "lazy", draggable: false });
    button5.append(icon("play"), element("span", "ellipsis", clip.brief), element("span", "muted number", `${clock(start3)} to ${clock(end)}`), strip);
    return button5;
  }
  var occurrences = (data2, id) => data2.rows.flatMap((clip) => clip.pieces.filter((piece) => piece[2] === id).map((piece) => (
    /** @type {[StringRow, number, number, number]} */
    [clip, piece[0], piece[1], piece[3]]
  ))).sort((a, b) => a[3] - b[3]);
  var drawActions2 = (data2, order) => {
    const box4 = find(ACTION_CARDS);
    if (!box4 || !isFresh(box4, [data2.key, data2.names, order])) return;
    const sorted = [...data2.actions];
    if (order === "count") sorted.sort((a, b) => b.count - a.count);
    if (order === "seconds") sorted.sort((a, b) => b.seconds - a.seconds);
    if (order === "name") sorted.sort((a, b) => Number(b.named) - Number(a.named) || a.name.localeCompare(b.name, void 0, { numeric: true }));
    redraw(box4, sorted.map(card));
  };
  var drawOccurrences = (data2, selection) => {
    const box4 = find(OCCURRENCES);
    if (!box4) return;
    const id = selection?.action === void 0 ? null : Number(selection.action);
    const known4 = id === null ? void 0 : data2.actions?.[id];
    for (const one of allWithin(document, ".action-card")) one.classList.toggle("chosen", known4 !== void 0 && Number(one.dataset.action) === id);
    need(ACTION_HINT).classList.toggle("hidden", Boolean(known4));
    need(ACTION_DETAIL).classList.toggle("hidden", !known4);
    if (!known4 || id === null || !isFresh(box4, [data2.key, data2.names, id, selection?.segment])) return;
    const all = occurrences(data2, id);
    need(ACTION_TITLE).textContent = `Action ${id}`;
    need(ACTION_COUNT).textContent = `${plural(all.length, "time")} in ${plural(known4.clips ?? 0, "recording")}`;
    const shown9 = all.slice(0, ROWS).map((one) => occurrence(one, id, String(one[3]) === String(selection?.segment)));
    redraw(box4, shown9);
    if (all.length > ROWS) box4.append(element("div", "muted selection-more", `and ${all.length - ROWS} more, all of them in the recordings above`));
    playsSelection(need(ACTION_ALL), { action: id });
  };

  // grammar/history.mjs
  var MOST2 = 100;
  function visited(past2, sentence) {
    const { key, list: list3, at: at3 } = past2;
    if (list3[at3] === sentence) return past2;
    if (list3[at3 - 1] === sentence) return { key, list: list3, at: at3 - 1 };
    if (list3[at3 + 1] === sentence) return { key, list: list3, at: at3 + 1 };
    const kept = [...list3.slice(Math.max(0, at3 + 2 - MOST2), at3 + 1), sentence];
    return { key, list: kept, at: kept.length - 1 };
  }

  // grammar/tree.mjs
  var showTree = (box4, svg, choose6) => {
    box4.choose = choose6;
    if (isFresh(box4, svg || "")) {
      const left = box4.scrollLeft;
      const focused = closest({ target: document.activeElement }, ".tree-node");
      const path2 = focused && box4.contains(focused) ? focused.dataset.path : null;
      box4.innerHTML = svg || "";
      box4.scrollLeft = left;
      const nodes = allWithin(box4, ".tree-node");
      const first = nodes.find((node) => node.dataset.path === path2) || nodes[0];
      first?.setAttribute("tabindex", "0");
      if (path2 !== null) first?.focus({ preventScroll: true });
    }
    if (box4.watched) return;
    box4.watched = true;
    box4.addEventListener("click", (event) => act(box4, closest(event, ".tree-node")));
    box4.addEventListener("keydown", (event) => {
      const node = closest(event, ".tree-node");
      if (!node) return;
      if (event.key === "Enter" || event.key === " ") act(box4, node);
      else if (!move4(box4, node, event.key)) return;
      event.preventDefault();
      event.stopPropagation();
    });
  };
  function act(box4, node) {
    if (!node) return;
    focus(box4, node);
    const { path: path2 = "", first, end } = node.dataset;
    box4.choose?.({ path: path2, first: Number(first), end: Number(end), leaf: node.classList.contains("tree-leaf") });
  }
  function focus(box4, node) {
    for (const other of allWithin(box4, '.tree-node[tabindex="0"]')) other.setAttribute("tabindex", "-1");
    node.setAttribute("tabindex", "0");
    node.focus();
  }
  function move4(box4, node, key) {
    const at3 = node.dataset.path ?? "";
    const cut = at3.lastIndexOf(".");
    const above = at3 === "" ? null : cut < 0 ? "" : at3.slice(0, cut);
    const inside2 = (path2) => allWithin(box4, ".tree-node").filter((one) => {
      const own2 = one.dataset.path ?? "";
      if (own2 === "" || own2 === path2) return false;
      const parent = own2.includes(".") ? own2.slice(0, own2.lastIndexOf(".")) : "";
      return parent === path2;
    });
    const siblings = above === null ? [node] : inside2(above);
    const number2 = siblings.indexOf(node);
    const ways = {
      ArrowUp: () => above === null ? null : allWithin(box4, ".tree-node").find((one) => one.dataset.path === above),
      ArrowDown: () => inside2(at3)[0],
      ArrowLeft: () => siblings[number2 - 1],
      ArrowRight: () => siblings[number2 + 1]
    };
    const next2 = ways[key];
    if (!next2) return false;
    const found = next2();
    if (found) focus(box4, found);
    return true;
  }
  var lightTree = (box4, number2) => {
    if (!box4 || box4.lit === number2) return;
    box4.lit = number2;
    for (const leaf of allWithin(box4, ".tree-leaf")) {
      const here3 = Number(leaf.dataset.first) === number2;
      leaf.classList.toggle("lit", here3);
      if (!here3) continue;
      const [outer, inner] = [box4.getBoundingClientRect(), leaf.getBoundingClientRect()];
      if (inner.left < outer.left || inner.right > outer.right) box4.scrollLeft += inner.left - outer.left - 40;
    }
  };
  document.addEventListener("click", (event) => {
    const button5 = closest(event, ".tree-png");
    const link2 = button5 && /** @type {HTMLAnchorElement | null} */
    document.getElementById(button5.dataset.link ?? "");
    if (link2?.href) savePicture(link2.href, "png", `${state2.data.dataset || "motionscape"} tree`);
  });

  // grammar/compose.mjs
  var KEYS6 = ["sentence", "pick", "up"];
  var HISTORY = "motionscape-routines";
  var on = false;
  var now3 = (
    /** @type {any} */
    {}
  );
  var view3 = {};
  var played2 = "";
  var lit2 = -1;
  var past = { key: "", list: [], at: -1 };
  var keysOf3 = (shown9) => Object.fromEntries(KEYS6.filter((key) => shown9?.[key]).map((key) => [key, shown9?.[key]]));
  var same3 = (a, b) => KEYS6.every((key) => (a?.[key] || "") === (b?.[key] || ""));
  var ready = () => Boolean(now3.name) && same3(now3.inputs, keysOf3(view3));
  var here2 = () => on && Boolean(find(COMPOSE_TREE)?.offsetParent);
  var onStage3 = () => String(player.frameOf(0)?.dataset || "").startsWith("~derive~");
  var goTo = (sentence, more2 = {}) => changeView({ sentence, pick: "", up: "", alt: "", ...more2 });
  function remember3(sentence) {
    if (past.key !== state2.data.key) {
      past = { key: state2.data.key, list: [], at: -1 };
      try {
        const kept = JSON.parse(sessionStorage.getItem(HISTORY) || "{}");
        if (kept.key === past.key) past = kept;
      } catch {
      }
    }
    const next2 = visited(past, sentence);
    if (next2 === past) return;
    past = next2;
    try {
      sessionStorage.setItem(HISTORY, JSON.stringify(past));
    } catch {
    }
  }
  function request3(data2) {
    return {
      dataset: data2.name ?? "",
      title: `New routine: ${plural(data2.actions.length, "action")}`,
      layout: "overlay",
      sync: "start",
      items: [{ clip: data2.clip, start: 0, end: data2.frames, label: "New routine", colours: data2.bands }]
    };
  }
  async function play6(data2, from) {
    played2 = data2.name ?? "";
    await player.show(request3(data2));
    if (from !== void 0) player.seek({ clip: data2.clip, frame: data2.spans[from][0] });
    player.play();
  }
  function string(data2) {
    const list3 = need(COMPOSE_STRING);
    if (!isFresh(list3, [data2.name, data2.actions, state2.data.names, now3.inputs, now3.chosen])) return;
    const chips = data2.actions.map((id, at3) => {
      const line3 = element("li", "compose-step");
      const button5 = actionChip(id);
      delete button5.dataset.store;
      button5.dataset.pick = String(at3);
      button5.title = `${actionOf(id).name}: choose it`;
      button5.setAttribute("aria-pressed", String(String(at3) === now3.inputs.pick));
      line3.classList.toggle("within", Boolean(now3.chosen && at3 >= now3.chosen.first && at3 < now3.chosen.end));
      line3.append(button5);
      return line3;
    });
    redraw(list3, chips);
  }
  function chosenWords() {
    const { chosen: chosen3 } = now3;
    if (!chosen3) return "Choose an action to change its part.";
    const span = chosen3.end - chosen3.first === 1 ? `action ${chosen3.first + 1}` : `actions ${chosen3.first + 1} to ${chosen3.end}`;
    const ways = chosen3.ways > 1 ? `${chosen3.ways} ways` : chosen3.varies ? "its parts can differ" : "one way only";
    return `${chosen3.name}: ${span}, ${ways}`;
  }
  function show4() {
    const busy = Boolean(view3.sentence) && !same3(now3.inputs, keysOf3(view3));
    need(COMPOSE_STRING).classList.toggle("busy", busy);
    const error = !busy && now3.error;
    need(COMPOSE_ERROR).classList.toggle("hidden", !error);
    need(COMPOSE_ERROR).textContent = error || "";
    const there = ready();
    need(COMPOSE_STRING).dataset.shown = busy ? "" : KEYS6.map((key) => now3.inputs?.[key] || "").join(" ");
    need(COMPOSE_STATUS).textContent = busy ? "Making the routine …" : there ? `${plural(now3.actions.length, "action")}, ${now3.seconds.toFixed(1)} s. ${now3.novel ? "Nobody performed it like this." : "It occurs like this in the recordings."}` : error ? "" : "Press New routine: chance makes one that keeps to the rules.";
    for (const name of ["play", "larger", "smaller", "others", "undo", "redo"]) {
      const usable2 = {
        play: there,
        undo: past.at > 0,
        redo: past.at < past.list.length - 1,
        larger: there && now3.chosen?.larger,
        smaller: there && now3.chosen?.smaller,
        others: there && now3.chosen?.varies
      }[name];
      within(document, `[data-compose="${name}"]`).disabled = !usable2;
    }
    if (busy && !now3.actions) return;
    need(COMPOSE_CHOSEN).textContent = there ? chosenWords() : "";
    if (!there) {
      if (error) for (const id of [COMPOSE_STRING, COMPOSE_TREE]) {
        need(id).replaceChildren();
        isFresh(need(id), "");
      }
    } else {
      string(now3);
      showTree(need(COMPOSE_TREE), now3.svg, choose3);
      drawSkateMeter(need(COMPOSE_METERS), "This routine", now3);
    }
    need(COMPOSE_WARNINGS).replaceChildren(...(there && now3.warnings || []).map((text) => element("p", "", text)));
    setLink(COMPOSE_BVH, there && `/api/bvh/${encodeURIComponent(now3.name ?? "")}/${encodeURIComponent(now3.clip)}`);
    setLink(COMPOSE_JSON, there && `/api/derivation/${now3.name?.split("~")[2]}.json`);
    setLink(COMPOSE_SVG, there && `/api/grammar-tree.svg?${downloadQuery(view3, { sentence: now3.code })}`);
    need(COMPOSE_SAVE).disabled = !there;
    for (const button5 of allWithin(document, ".compose-recipe")) {
      const text = there && now3.recipes?.[button5.dataset.recipe ?? ""];
      button5.disabled = !text;
      button5.title = button5.dataset.recipe ?? "";
      button5.dataset.copy = text || "";
    }
  }
  function choose3({ path: path2, first, leaf }) {
    if (!ready()) return;
    if (leaf) return pick2(first);
    const depth2 = (text) => text === "" ? 0 : text.split(".").length;
    const inner = now3.parents[first];
    changeView({ pick: String(first), up: String(Math.max(0, depth2(inner) - depth2(path2)) || ""), alt: "" });
  }
  function pick2(at3) {
    const again = String(at3) === now3.inputs.pick && !now3.inputs.up;
    changeView({ pick: again ? "" : String(at3), up: "", alt: "" });
    if (!again && now3.name === played2 && onStage3()) player.seek({ clip: now3.clip, frame: now3.spans[at3][0] });
  }
  var whole2 = (text, low, high) => Math.min(Math.max(Math.round(Number(text) || low), low), high);
  var actions3 = {
    new() {
      const most = whole2(need(COMPOSE_MOST).value, 1, Number(need(COMPOSE_MOST).max));
      const seed = Number((/^random:(\d+)/.exec(view3.sentence || "") || [0, past.list.length])[1]) + 1;
      goTo(`random:${seed}:${most}`);
    },
    undo: () => past.at > 0 && goTo(past.list[past.at - 1]),
    redo: () => past.at < past.list.length - 1 && goTo(past.list[past.at + 1]),
    play: () => ready() && play6(now3),
    larger: () => changeView({ up: String(Number(now3.inputs.up || 0) + 1), alt: "" }),
    smaller: () => changeView({ up: String(Math.max(0, Number(now3.inputs.up || 0) - 1) || ""), alt: "" }),
    others: () => changeView({ alt: String(Number(view3.alt || 0) + 1) })
  };
  document.addEventListener("click", (event) => {
    const button5 = closest(event, "[data-compose]");
    if (button5 && !button5.disabled && here2()) actions3[button5.dataset.compose ?? ""]();
    const chip2 = closest(event, "[data-pick]");
    if (chip2 && here2() && ready()) pick2(Number(chip2.dataset.pick));
  });
  document.addEventListener("keydown", (event) => {
    if (!here2() || !(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
    if (closest(event, "input, textarea")) return;
    event.preventDefault();
    actions3[event.shiftKey ? "redo" : "undo"]();
  });
  window.addEventListener("stage-frame", (event) => {
    const item = event.detail.items[0];
    const ours = here2() && now3.name && item?.dataset === now3.name;
    const at3 = ours ? now3.spans.findIndex(([a, b]) => item.frame >= a && item.frame < b) : -1;
    if (at3 === lit2) return;
    lit2 = at3;
    lightTree(find(COMPOSE_TREE), at3);
    allWithin(document, `#${COMPOSE_STRING} .compose-step`).forEach((step3, number2) => step3.classList.toggle("lit", number2 === at3));
  });
  var composition = () => ({ on, now: now3, view: view3, ready: ready(), play: () => play6(now3) });
  var drawCompose = (data2, shown9, selection) => {
    view3 = shown9 || {};
    const entered = view3.show === "compose" && !on;
    on = view3.show === "compose" && Boolean(find(COMPOSE_TREE));
    if (!on || !state2.data.key) return;
    if (!view3.sentence) return actions3.new();
    const [, , most] = /^random:(\d+):(\d+)/.exec(view3.sentence) || [];
    if (most && document.activeElement?.id !== COMPOSE_MOST) clientside.set_props(COMPOSE_MOST, { value: Number(most) });
    remember3(view3.sentence);
    if (data2) now3 = data2;
    if (data2 && data2.key !== state2.data.key && !data2.error) now3 = /** @type {any} */
    {};
    show4();
    if (!ready()) return;
    if (entered && selection && Object.keys(selection).length) setStore(SELECTION, {});
    if (!view3.alt && (now3.name !== played2 || entered && !onStage3())) play6(now3);
  };

  // grammar/others.mjs
  var LETTERS = "ABCDEFGH";
  var playing = "";
  var KEYS7 = ["sentence", "pick", "up", "alt"];
  var matches = (data2, view4) => KEYS7.every((key) => (data2?.inputs?.[key] || "") === (view4[key] || ""));
  function request4(data2) {
    return {
      dataset: data2.others[0].name,
      title: `${plural(data2.others.length, "other way")} for ${data2.part}`,
      layout: "side",
      sync: "start",
      items: data2.others.map((other, i) => ({
        dataset: other.name,
        clip: other.clip,
        start: other.start,
        end: other.stop,
        label: LETTERS[i],
        colours: other.bands
      }))
    };
  }
  function card2(other, i) {
    const box4 = element("section", "other-card");
    const head3 = element("div", "other-head");
    head3.append(element("b", "", LETTERS[i]), element("span", "muted number", `${plural(other.end - other.first, "action")}, ${other.seconds.toFixed(1)} s`));
    const use = element("button", "walk-button", "Use this");
    use.type = "button";
    use.setAttribute("aria-label", `Use ${LETTERS[i]}`);
    use.addEventListener("click", () => goTo(other.code));
    head3.append(element("span", "spacer"), use);
    const chips = element("div", "way-parts");
    chips.append(...other.actions.slice(other.first, other.end).map((id) => {
      const chip2 = element("span", "action-chip plain-chip", actionOf(id).short);
      paintAction(chip2, actionOf(id));
      chip2.title = actionOf(id).name;
      return chip2;
    }));
    if (other.first === other.end) chips.append(element("span", "muted", "left out"));
    box4.append(head3, chips);
    return box4;
  }
  var drawOthers = (data2, view4) => {
    const box4 = find(COMPOSE_OTHERS);
    if (!box4) return;
    const wanted2 = view4.show === "compose" && view4.alt;
    box4.classList.toggle("hidden", !wanted2);
    if (!wanted2) {
      if (playing && view4.show === "compose" && composition().ready) composition().play();
      playing = "";
      return;
    }
    const shown9 = data2 !== null && matches(data2, view4) ? data2 : null;
    if (!isFresh(box4, [shown9, state2.data.names])) return;
    const head3 = element("div", "other-title");
    head3.append(element("h3", "", shown9?.others ? `Other ways for ${shown9.part}` : "Other ways"));
    const close = element("button", "walk-button", "Keep it as it is");
    close.type = "button";
    close.addEventListener("click", () => changeView({ alt: "" }));
    const again = element("button", "walk-button", "Another four");
    again.type = "button";
    again.disabled = !shown9;
    again.addEventListener("click", () => changeView({ alt: String(Number(view4.alt) + 1) }));
    const replay = element("button", "walk-button", "Play again");
    replay.type = "button";
    replay.disabled = !shown9?.others?.length;
    replay.addEventListener("click", () => shown9 && player.show(request4(shown9))?.then(() => player.play()));
    head3.append(element("span", "spacer"), replay, again, close);
    const body2 = element("div", "other-cards");
    if (!shown9) body2.append(element("p", "muted", "Making four other ways …"));
    else if (shown9.error || !shown9.others.length) body2.append(element("p", "muted", shown9.error || "There is no other way for this part; choose a larger one."));
    else body2.append(...shown9.others.map(card2));
    box4.replaceChildren(head3, body2);
    const stamp = shown9?.others?.length ? JSON.stringify(shown9.inputs) : "";
    if (!shown9 || !stamp || stamp === playing) return;
    playing = stamp;
    player.show(request4(shown9));
  };

  // grammar/routines.mjs
  var now4 = {};
  var selectionOf2 = (routine, first, end) => ({
    clip: routine.clip,
    start: routine.leaves[first][0],
    end: routine.leaves[end - 1][1],
    as: "actions"
  });
  function row5(routine, number2, brief) {
    const line3 = element("li");
    const button5 = element("button", "routine-row");
    button5.type = "button";
    button5.dataset.routine = String(number2);
    const name = `${routine.clip}, ${clock(routine.seconds[0])} to ${clock(routine.seconds[1])}`;
    button5.setAttribute("aria-label", `Routine ${number2 + 1}: ${name}, ${plural(routine.actions.length, "action")}`);
    button5.title = `${name}: ${routine.actions.map((id) => actionOf(id).name).join(", ")}`;
    const squares = element("span", "routine-squares");
    squares.append(...routine.actions.map((id) => {
      const square = element("span", "routine-square");
      square.style.setProperty("--tone", actionOf(id).colour);
      return square;
    }));
    button5.append(
      element("span", "number routine-number", String(number2 + 1)),
      element("span", "ellipsis routine-clip", brief),
      element("span", "muted number", clock(routine.seconds[0])),
      squares
    );
    line3.append(button5);
    return line3;
  }
  function play7(routine, first = 0, end = routine.leaves.length) {
    const selection = selectionOf2(routine, first, end);
    ahead.play(selection);
    setStore(SELECTION, selection);
  }
  var drawRoutines = (shown9, data2, view4) => {
    const list3 = find(ROUTINE_LIST);
    if (!list3 || !data2?.routines) return;
    if (isFresh(list3, [data2.key, data2.names])) {
      const brief = new Map(data2.rows.map((clip) => [clip.clip, clip.brief]));
      redraw(list3, data2.routines.map((routine2, number2) => row5(routine2, number2, brief.get(routine2.clip))));
    }
    if (!shown9 || shown9.key !== data2.key) return;
    const routine = data2.routines[shown9.number];
    now4 = { routine, number: shown9.number };
    for (const button5 of allWithin(list3, ".routine-row")) {
      const here3 = Number(button5.dataset.routine) === shown9.number;
      button5.classList.toggle("chosen", here3);
      button5.setAttribute("aria-pressed", String(here3));
    }
    need(ROUTINE_TITLE).textContent = `Routine ${shown9.number + 1}`;
    need(ROUTINE_COUNT).textContent = `${routine.clip}, ${plural(routine.actions.length, "action")}`;
    showTree(need(ROUTINE_TREE), shown9.svg, ({ first, end }) => play7(routine, first, end));
    setLink(ROUTINE_SVG, `/api/grammar-tree.svg?${downloadQuery(view4, { routine: shown9.number })}`);
  };
  document.addEventListener("click", (event) => {
    if (closest(event, `#${ROUTINE_PLAY}`) && now4.routine) play7(now4.routine);
    const button5 = closest(event, ".routine-row");
    if (!button5) return;
    const number2 = Number(button5.dataset.routine);
    changeView({ routine: number2 ? String(number2) : "" });
    play7(state2.data.routines[number2]);
  });
  window.addEventListener("stage-frame", (event) => {
    const box4 = find(ROUTINE_TREE);
    if (!box4?.offsetParent || !now4.routine) return;
    const item = event.detail.items[0];
    const here3 = item && item.clip === now4.routine.clip && item.dataset === state2.data.dataset;
    lightTree(box4, here3 ? now4.routine.leaves.findIndex(([start3, end]) => item.frame >= start3 && item.frame < end) : -1);
  });

  // grammar/rules.mjs
  var FIRST = 8;
  var open5 = /* @__PURE__ */ new Set();
  var named = (id) => (state2.data.rules || []).find((phrase) => phrase.id === id);
  var phraseChip = (id) => {
    const phrase = named(id);
    const button5 = element("button", "phrase-chip", phrase ? phrase.name : id);
    button5.type = "button";
    button5.title = "Show what it may be";
    button5.dataset.phrase = id;
    return button5;
  };
  function way2({ parts: symbols, count }, seen3) {
    const line3 = element("li", "way");
    const bar = element("span", "way-bar");
    bar.style.setProperty("--share", String(seen3 ? count / seen3 : 0));
    const many = element("span", "number way-count", `${count}×`);
    many.title = `Taken ${plural(count, "time")} of ${seen3}`;
    const body2 = element("span", "way-parts");
    body2.append(...symbols.map((one) => typeof one === "number" ? actionChip(one) : phraseChip(one)));
    if (!symbols.length) body2.append(element("span", "muted", "nothing: it may be left out"));
    line3.append(many, bar, body2);
    return line3;
  }
  function card3(phrase, start3) {
    const box4 = element("section", "phrase-card");
    box4.id = PHRASE + phrase.id;
    box4.tabIndex = -1;
    const head3 = element("div", "phrase-head");
    head3.append(element("h3", "", start3 ? "A routine" : phrase.name));
    const kinds2 = phrase.ways.length === 1 ? "always goes like this" : `goes one of ${phrase.ways.length} ways`;
    head3.append(element("span", "muted", `${kinds2}, seen ${plural(phrase.seen, "time")}`));
    if (phrase.cyclic) {
      const mark3 = element("span", "phrase-cyclic", "can contain itself");
      mark3.title = "New routines may go round it more than once";
      head3.append(mark3);
    }
    const list3 = element("ol", "ways");
    const shown9 = open5.has(phrase.id) ? phrase.ways : phrase.ways.slice(0, FIRST);
    list3.append(...shown9.map((one) => way2(one, phrase.seen)));
    box4.append(head3, list3);
    if (phrase.ways.length > shown9.length) {
      const more2 = element("button", "text-button", `Show ${phrase.ways.length - shown9.length} more`);
      more2.type = "button";
      more2.addEventListener("click", () => {
        open5.add(phrase.id);
        box4.replaceWith(card3(phrase, start3));
        allWithin(need(PHRASE + phrase.id), ".way")[FIRST]?.querySelector("button")?.focus();
      });
      box4.append(more2);
    }
    return box4;
  }
  var drawRules = (data2) => {
    const box4 = find(GRAMMAR_RULES);
    if (!box4 || !isFresh(box4, [data2.key, data2.names])) return;
    open5.clear();
    box4.replaceChildren(...data2.rules.map((phrase, number2) => card3(phrase, number2 === 0)));
  };
  document.addEventListener("click", (event) => {
    const chip2 = closest(event, ".phrase-chip");
    const phraseCard = chip2 && find(PHRASE + chip2.dataset.phrase);
    if (!phraseCard || !phraseCard.offsetParent) return;
    phraseCard.scrollIntoView({ block: "center", behavior: "smooth" });
    phraseCard.focus({ preventScroll: true });
    phraseCard.classList.add("shown");
    setTimeout(() => phraseCard.classList.remove("shown"), 1200);
  });

  // grammar/strings.mjs
  var MOST_FIGURES2 = 24;
  var place3 = (node, start3, end, seconds) => {
    node.style.left = `${100 * start3 / seconds}%`;
    node.style.width = `${Math.max(100 * (end - start3) / seconds, 0.15)}%`;
  };
  function block([start3, end, id, number2], seconds) {
    const action = actionOf(id);
    const made = playsSelection(element("button", "string-block"), { action: id, segment: number2 });
    made.type = "button";
    made.append(element("span", "", action.short));
    made.tabIndex = -1;
    made.title = `${action.name}, ${number2 + 1} of ${action.count}, ${clock(start3)} to ${clock(end)}`;
    made.setAttribute("aria-label", made.title);
    made.dataset.action = String(id);
    made.dataset.segment = String(number2);
    paintAction(made, action);
    place3(made, start3, end, seconds);
    return made;
  }
  function row6(clip, longest2) {
    const line3 = element("div", "string-row");
    line3.setAttribute("role", "listitem");
    const head3 = playsSelection(element("button", "string-clip ellipsis", clip.brief), { clip: clip.clip, as: "actions" });
    head3.type = "button";
    head3.dataset.clip = clip.clip;
    head3.title = `Play ${clip.clip} with its actions`;
    const time = element("div", "string-time");
    time.style.width = `${Math.max(100 * clip.seconds / longest2, 0.5)}%`;
    Object.assign(time.dataset, { clip: clip.clip, seconds: clip.seconds, fps: clip.fps });
    if (clip.labels.length) {
      const labels2 = element("div", "string-labels");
      labels2.append(...clip.labels.map(([start3, end, name]) => {
        const made = element("span", "string-label", name);
        made.title = `${name}, ${clock(start3)} to ${clock(end)}`;
        place3(made, start3, end, clip.seconds);
        return made;
      }));
      time.append(labels2);
    }
    const blocks = element("div", "string-blocks");
    blocks.append(...clip.pieces.map((piece) => block(piece, clip.seconds)));
    if (childrenOf(blocks)[0]) childrenOf(blocks)[0].tabIndex = 0;
    for (const cut of clip.cuts) {
      const mark3 = element("span", "string-cut");
      mark3.style.left = `${100 * cut / clip.seconds}%`;
      blocks.append(mark3);
    }
    time.append(blocks, element("div", "string-now"));
    const track = element("div", "string-track");
    track.append(time);
    line3.append(head3, track);
    return line3;
  }
  var drawString = (data2) => {
    const box4 = find(GRAMMAR_STRING);
    if (!box4 || !isFresh(box4, [data2.key, data2.names])) return;
    const longest2 = Math.max(...data2.rows.map((clip) => clip.seconds), 1e-3);
    box4.replaceChildren(...data2.rows.map((clip) => row6(clip, longest2)));
  };
  var markChosen = (selection) => {
    const chosen3 = selection?.action === void 0 ? null : String(selection.action);
    const box4 = find(GRAMMAR_STRING);
    if (!box4) return;
    box4.classList.toggle("one-action", chosen3 !== null);
    for (const made of allWithin(box4, ".string-block")) {
      const same4 = made.dataset.action === chosen3;
      made.classList.toggle("same", same4);
      made.setAttribute("aria-pressed", String(same4 && made.dataset.segment === String(selection?.segment)));
    }
    for (const head3 of allWithin(box4, ".string-clip")) head3.classList.toggle("chosen", selection?.clip === head3.dataset.clip);
  };
  document.addEventListener("keydown", (event) => {
    const at3 = closest(event, ".string-block");
    if (!at3) return;
    const lines2 = allWithin(around(at3, `#${GRAMMAR_STRING}`), ".string-blocks");
    const siblings = (
      /** @type {any} */
      at3.parentNode
    );
    const line3 = lines2.indexOf(siblings);
    const blocks = allWithin(siblings, ".string-block");
    const number2 = blocks.indexOf(at3);
    const ways = {
      ArrowRight: () => blocks[number2 + 1],
      ArrowLeft: () => blocks[number2 - 1],
      ArrowDown: () => lines2[line3 + 1]?.querySelector(".string-block"),
      ArrowUp: () => lines2[line3 - 1]?.querySelector(".string-block")
    };
    const next2 = ways[event.key];
    if (!next2) return;
    event.preventDefault();
    event.stopPropagation();
    next2()?.focus();
  });
  var LARGEST = 32;
  document.addEventListener("click", (event) => {
    const button5 = closest(event, ".string-zoom");
    const box4 = button5 && find(GRAMMAR_STRING);
    if (!box4) return;
    const before2 = Number(box4.dataset.zoom || 1);
    const zoom4 = Math.min(Math.max(before2 * (button5.dataset.zoom === "in" ? 2 : 0.5), 1), LARGEST);
    const middle = box4.scrollLeft + box4.clientWidth / 2;
    box4.dataset.zoom = String(zoom4);
    box4.style.setProperty("--zoom", String(zoom4));
    box4.scrollLeft = middle * zoom4 / before2 - box4.clientWidth / 2;
  });
  function follow2(box4, line3) {
    if (Number(box4.dataset.zoom || 1) === 1 || !player.playing) return;
    const [outer, at3] = [box4.getBoundingClientRect(), line3.getBoundingClientRect().left];
    if (at3 < outer.left + 140 || at3 > outer.right) box4.scrollLeft += at3 - outer.left - 160;
  }
  var lit3 = [];
  function cursor2() {
    const box4 = find(GRAMMAR_STRING);
    if (!box4 || !box4.offsetParent) return;
    for (const line3 of lit3) line3.style.display = "";
    lit3 = [];
    for (let i = 0; i < MOST_FIGURES2; i++) {
      const item = player.frameOf(i);
      if (!item) break;
      if (String(item.dataset || "").startsWith("~")) continue;
      const time = allWithin(box4, `.string-time[data-clip="${CSS.escape(item.clip)}"]`)[0];
      const line3 = time && childrenOf(time).at(-1);
      if (!line3 || lit3.includes(line3)) continue;
      line3.style.display = "block";
      line3.style.left = `${100 * item.frame / Number(time.dataset.fps) / Number(time.dataset.seconds)}%`;
      lit3.push(line3);
    }
    if (lit3.length === 1) follow2(box4, lit3[0]);
  }
  setInterval(cursor2, 80);

  // grammar/grammar.mjs
  register("grammar", {
    /**
     * @param {GrammarData | null} data
     * @param {Selection | null} selection
     * @param {string | null} order
     * @param {unknown} _place
     */
    draw(data2, selection, order, _place) {
      if (!data2 || !find(GRAMMAR_STRING)) return clientside.no_update;
      state2.data = data2;
      drawString(data2);
      drawActions2(data2, order);
      drawOccurrences(data2, selection);
      drawRules(data2);
      markChosen(selection);
      return clientside.no_update;
    },
    /**
     * A point of a chart over the number of actions: its result comes on the page.
     * @param {{ points?: { customdata?: any }[] } | null} click
     */
    open(click) {
      const change2 = click?.points?.[0]?.customdata;
      if (typeof change2 === "string") changeView(JSON.parse(change2));
      return clientside.no_update;
    },
    /** @param {ShownRoutine | null} shown @param {GrammarData | null} data @param {View | null} view */
    routine(shown9, data2, view4) {
      if (data2) state2.data = data2;
      drawRoutines(shown9, data2, view4 || {});
      return clientside.no_update;
    },
    /**
     * @param {Composition | null} made
     * @param {View | null} view
     * @param {GrammarData | null} data
     * @param {Selection | null} selection
     */
    compose(made, view4, data2, selection) {
      if (data2) state2.data = data2;
      drawCompose(made, view4, selection);
      return clientside.no_update;
    },
    /** @param {OtherWays | null} data @param {View | null} view */
    others(data2, view4) {
      drawOthers(data2, view4 || {});
      return clientside.no_update;
    }
  });

  // motion_map/data.mjs
  var MapData = class {
    /** @param {ArrayBuffer} buffer @param {string} key */
    constructor(buffer, key) {
      const length = new DataView(buffer).getUint32(0, true);
      const header = (
        /** @type {MapHeader} */
        JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)))
      );
      this.key = key;
      this.nx = header.grid[0];
      this.ny = header.grid[1];
      this.fps = header.fps;
      this.runs = header.runs;
      this.joints = header.joints;
      this.roles = header.roles;
      this.sides = header.sides;
      this.parents = header.parents;
      this.lengths = header.lengths;
      this.clips = header.clips;
      this.regions = header.regions;
      this.icons = header.icons;
      this.usual = header.usual;
      this.n = this.nx * this.ny;
      this.width = 3 * this.joints.length;
      let at3 = 4 + length;
      const take4 = (n) => (at3 += 4 * n) - 4 * n;
      this.weights = new Float32Array(buffer, take4(this.n * this.width), this.n * this.width);
      const ints = () => new Int32Array(buffer, take4(this.runs), this.runs);
      const floats = () => new Float32Array(buffer, take4(this.runs), this.runs);
      const table3 = { clip: ints(), start: ints(), end: ints(), node: ints(), distance: floats(), ahead: floats(), aside: floats() };
      this.table = table3;
      this.seconds = new Float32Array(this.n);
      this.speed = new Float32Array(this.runs);
      this.fastest = 0;
      for (let r = 0; r < this.runs; r++) {
        this.seconds[table3.node[r]] += (table3.end[r] - table3.start[r]) / this.fps;
        this.speed[r] = Math.hypot(table3.ahead[r], table3.aside[r]);
        this.fastest = Math.max(this.fastest, this.speed[r]);
      }
      this.numbers = new Map(this.clips.map((clip, k) => [clip.name, k]));
      this.reach = Math.ceil(10 * this.spread()) / 10;
      this.postures = /* @__PURE__ */ new Map();
      this.near = /* @__PURE__ */ new Map();
    }
    /** Largest distance of a posture from the mean one. */
    spread() {
      const mean = new Float64Array(this.width);
      for (let k = 0; k < this.weights.length; k++) mean[k % this.width] += this.weights[k] / this.n;
      let most = 0;
      for (let node = 0; node < this.n; node++) most = Math.max(most, this.apart(node, mean));
      return most;
    }
    /** @param {number} x @param {number} y */
    index(x, y) {
      return x * this.ny + y;
    }
    /** @param {number} node */
    place(node) {
      return [Math.floor(node / this.ny), node % this.ny];
    }
    /**
     * Distance of a node's model vector to a vector.
     * @param {number} node
     * @param {ArrayLike<number>} vector
     */
    apart(node, vector) {
      let sum2 = 0;
      for (let k = 0, at3 = node * this.width; k < this.width; k++, at3++) sum2 += (this.weights[at3] - vector[k]) ** 2;
      return Math.sqrt(sum2);
    }
    /** @param {number} node */
    model(node) {
      return this.weights.subarray(node * this.width, (node + 1) * this.width);
    }
    /**
     * Distances (n) of all nodes to a key node's model vector.
     * @param {number} node
     */
    distances(node) {
      if (!this.near.has(node)) {
        const own2 = this.model(node), distances = new Float32Array(this.n);
        for (let k = 0; k < this.n; k++) distances[k] = this.apart(k, own2);
        if (this.near.size > 64) this.near.clear();
        this.near.set(node, distances);
      }
      return (
        /** @type {Float32Array} */
        this.near.get(node)
      );
    }
    /**
     * The node nearest to a vector of joint positions, and the distance.
     * @param {ArrayLike<number>} vector
     */
    nearest(vector) {
      let [best, least] = [0, Infinity];
      for (let node = 0; node < this.n; node++) {
        const apart = this.apart(node, vector);
        if (apart < least) [best, least] = [node, apart];
      }
      return { node: best, distance: least };
    }
    /**
     * The posture of a node, bones at their real lengths: positions (3 n_joints), the pelvis at the origin.
     * @param {number} node
     */
    posture(node) {
      if (!this.postures.has(node)) this.postures.set(node, this.withBones(this.model(node)));
      return (
        /** @type {Float64Array} */
        this.postures.get(node)
      );
    }
    /** @param {ArrayLike<number>} vector */
    withBones(vector) {
      const made = new Float64Array(this.width);
      this.parents.forEach((parent, joint) => {
        const from = (array, k) => parent < 0 ? 0 : array[3 * parent + k];
        const bone = [0, 1, 2].map((k) => vector[3 * joint + k] - from(vector, k));
        const size = Math.hypot(...bone);
        const way3 = size > 1e-9 ? bone.map((part2) => part2 / size) : [0, 1, 0];
        for (let k = 0; k < 3; k++) made[3 * joint + k] = from(made, k) + way3[k] * this.lengths[joint];
      });
      return made;
    }
    /**
     * Whether a run travels as a pace says: {slowest, fastest, way}.
     * @param {number} run
     * @param {Pace | null} pace
     */
    allows(run, pace) {
      if (!pace) return true;
      const speed = this.speed[run];
      if (speed < pace.slowest || speed > pace.fastest) return false;
      if (!pace.way || pace.way === "any") return true;
      const straight = pace.way === "forward" || pace.way === "backward";
      let [along2, across] = [this.table.ahead[run], this.table.aside[run]];
      if (!straight) [along2, across] = [across, along2];
      if (pace.way === "backward" || pace.way === "right") along2 = -along2;
      return along2 > 0 && along2 >= Math.abs(across);
    }
    /**
     * Stretches that pass all keys in order, best first; as core/motion_map/keypose_search.py, which says why. keys: node
     * numbers; reach: the paper's T. Gives [{clip, start, end, distance}], clip a number, analysis frames.
     * @param {number[]} keys
     * @param {number} reach
     * @param {Pace | null} pace
     */
    search(keys, reach, pace) {
      if (!keys.length) return [];
      const { clip, start: start3, end, node } = this.table;
      const passes = keys.map((key) => {
        const apart = this.distances(key);
        const rows2 = [];
        for (let r = 0; r < this.runs; r++) {
          const on2 = node[r];
          if ((on2 === key || apart[on2] < reach) && this.allows(r, pace)) rows2.push(r);
        }
        return { rows: rows2, apart };
      });
      let chains = passes[0].rows.map((r) => ({ first: r, last: r, distance: passes[0].apart[node[r]] }));
      for (const { rows: rows2, apart } of passes.slice(1)) {
        let at3 = 0;
        const next2 = [];
        for (const chain of chains) {
          while (at3 < rows2.length && rows2[at3] <= chain.last) at3++;
          if (at3 === rows2.length) break;
          if (clip[rows2[at3]] !== clip[chain.last]) continue;
          next2.push({ first: chain.first, last: rows2[at3], distance: chain.distance + apart[node[rows2[at3]]] });
        }
        chains = next2;
      }
      const shortest = chains.filter((chain, k) => k + 1 === chains.length || chains[k + 1].last !== chain.last);
      const hits = shortest.map((chain) => ({
        clip: clip[chain.first],
        start: start3[chain.first],
        end: end[chain.last],
        distance: chain.distance
      }));
      const rough = (value) => Math.round(value * 1e5);
      return hits.sort((a, b) => rough(a.distance) - rough(b.distance) || a.end - a.start - (b.end - b.start) || a.clip - b.clip || a.start - b.start);
    }
    /**
     * A stretch in frames of the clip's own rate: {clip: name, start, end}.
     * @param {{ clip: number, start: number, end: number }} hit
     */
    segment({ clip, start: start3, end }) {
      const { name, frames, fps } = this.clips[clip];
      const even = (value) => value % 1 === 0.5 ? 2 * Math.round(value / 2) : Math.round(value);
      const first = Math.min(even(start3 * fps / this.fps), frames - 1);
      return { clip: name, start: first, end: Math.max(Math.min(even(end * fps / this.fps), frames), first + 1) };
    }
    /**
     * The node on which a frame (of the clip's own rate) of a clip of the map lies, or -1.
     * @param {string} name
     * @param {number} frame
     */
    nodeAt(name, frame) {
      const k = this.numbers.get(name);
      if (k === void 0) return -1;
      const { clip, start: start3, end, node } = this.table;
      const wanted2 = Math.max(Math.round(frame * this.fps / this.clips[k].fps), 0);
      let [low, high] = [0, this.runs - 1];
      while (low < high) {
        const middle = low + high + 1 >> 1;
        if (clip[middle] < k || clip[middle] === k && start3[middle] <= wanted2) low = middle;
        else high = middle - 1;
      }
      return clip[low] === k && start3[low] <= wanted2 && wanted2 <= end[low] ? node[low] : -1;
    }
  };
  var loaded = /* @__PURE__ */ new Map();
  var loadMap = (key) => {
    if (!loaded.has(key)) {
      const answer2 = fetch(`/api/map/${key}.bin`).then(async (response) => {
        if (!response.ok) throw new Error((await response.json().catch(() => ({}))).error || "The map cannot be read.");
        return new MapData(await response.arrayBuffer(), key);
      });
      loaded.set(key, answer2);
      answer2.catch(() => loaded.delete(key));
      if (loaded.size > 4) loaded.delete(
        /** @type {string} */
        loaded.keys().next().value
      );
    }
    return (
      /** @type {Promise<MapData>} */
      loaded.get(key)
    );
  };

  // motion_map/ids.mjs
  var MAP_PLOT = "map-plot";
  var MAP_PREVIEW = "map-preview";
  var MAP_KEYS = "map-keys";
  var MAP_REACH = "map-reach";
  var MAP_REACH_LABEL = "map-reach-label";
  var MAP_REACH_BOX = "map-reach-box";
  var MAP_REACH_VALUE = "map-reach-value";
  var MAP_COUNT = "map-count";
  var MAP_PLAY_ALL = "map-play-all";
  var MAP_HITS = "map-hits";
  var MAP_EDITOR = "map-editor";
  var MAP_EDITOR_TITLE = "map-editor-title";

  // motion_map/figure.mjs
  var HEAD2 = 0.105;
  var PENS = { left: 0.06, right: 0.06, centre: 0.075 };
  var [YAW2, PITCH2] = [35 * Math.PI / 180, 8 * Math.PI / 180];
  var VIEWS2 = {
    front: ([x, y, z]) => [x, -y, z],
    side: ([x, y, z]) => [z, -y, -x],
    top: ([x, y, z]) => [x, z, y],
    icon: ([x, y, z]) => {
      const [a, c] = [Math.cos(YAW2) * x + Math.sin(YAW2) * z, Math.cos(YAW2) * z - Math.sin(YAW2) * x];
      return [a, c * Math.sin(PITCH2) - y * Math.cos(PITCH2), c];
    }
  };
  var jointOf2 = (posture, j) => j < 0 ? [0, 0, 0] : [posture[3 * j], posture[3 * j + 1], posture[3 * j + 2]];
  var minus = (a, b) => a.map((part2, k) => part2 - b[k]);
  var plus = (a, b, scale3 = 1) => a.map((part2, k) => part2 + scale3 * b[k]);
  var cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  var unit = (a) => {
    const size = Math.hypot(...a);
    return size > 1e-6 ? a.map((part2) => part2 / size) : null;
  };
  function forward(map, posture) {
    const [left, right] = ["left_shoulder", "right_shoulder"].map((role) => map.roles.indexOf(role));
    if (left < 0 || right < 0) return [0, 0, 1];
    const [a, b] = [jointOf2(posture, left), jointOf2(posture, right)];
    return unit(cross(minus(a, b), plus(a, b))) || [0, 0, 1];
  }
  var sideOf2 = (map, j) => /_(clavicle|shoulder|hip)$/.test(map.roles[j]) ? "centre" : map.sides[j];
  function drawFigure(map, posture, view4) {
    const see = VIEWS2[view4];
    const text = (point) => {
      const [a, b] = see(point);
      return `${a.toFixed(3)} ${b.toFixed(3)}`;
    };
    const layers = ["left", "right", "centre"].map((side) => {
      const bones = map.parents.map((parent, j) => [parent, j]).filter(([, j]) => sideOf2(map, j) === side);
      const d = bones.map(([parent, j]) => `M${text(jointOf2(posture, parent))}L${text(jointOf2(posture, j))}`).join("");
      const depth2 = bones.reduce((sum2, [, j]) => sum2 + see(jointOf2(posture, j))[2], 0) / Math.max(bones.length, 1);
      const group = svgElement("g", { class: `map-limb-${side}` }, svgElement("path", { d, "stroke-width": PENS[side], fill: "none" }));
      if (side === "centre") group.append(...head(map, posture, see));
      return { group, depth: depth2 };
    });
    layers.sort((a, b) => a.depth - b.depth);
    return svgElement("g", { class: "map-figure" }, ...layers.map((layer) => layer.group));
  }
  function head(map, posture, see) {
    const at3 = map.roles.indexOf("head");
    if (at3 < 0) return [];
    const up = unit(minus(jointOf2(posture, at3), jointOf2(posture, map.parents[at3]))) || [0, 1, 0];
    const centre = plus(jointOf2(posture, at3), up, HEAD2);
    const [middle, tip] = [see(centre), see(plus(centre, forward(map, posture), 1.5 * HEAD2))];
    const ball2 = svgElement("circle", { cx: middle[0], cy: middle[1], r: HEAD2, class: "map-head" });
    if (tip[2] < middle[2] - 1e-6) return [ball2];
    return [ball2, svgElement("path", { d: `M${middle[0]} ${middle[1]}L${tip[0]} ${tip[1]}`, "stroke-width": 0.045, class: "map-nose" })];
  }
  function figurePicture(map, posture, view4, className = "map-picture") {
    const fit2 = view4 === "icon";
    let box4 = [-1, -1.05, 2, 2.1];
    if (fit2) {
      const seen3 = [[0, 0, 0], ...map.parents.map((_, j) => jointOf2(posture, j))].map(VIEWS2.icon);
      const [xs, ys] = [seen3.map((p) => p[0]), seen3.map((p) => p[1])];
      const side = Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys), 1.2) + 0.34;
      box4 = [(Math.max(...xs) + Math.min(...xs) - side) / 2, (Math.max(...ys) + Math.min(...ys) - side) / 2 - 0.08, side, side];
    }
    const svg = svgElement("svg", { viewBox: box4.map((part2) => part2.toFixed(3)).join(" "), class: className, "aria-hidden": "true" });
    svg.append(drawFigure(map, posture, view4));
    return svg;
  }

  // motion_map/bones.mjs
  function chainOf(map, joint) {
    const chain = [joint];
    const trunk2 = (j) => j < 0 || /^(chest|spine|neck|head)$|_(clavicle|shoulder|hip)$/.test(map.roles[j]);
    const inTrunk = trunk2(joint);
    for (let j = map.parents[joint]; ; j = map.parents[j]) {
      chain.push(j);
      if (j < 0 || !inTrunk && trunk2(j)) return chain;
    }
  }
  function dragJoint(map, posture, joint, goal) {
    const chain = chainOf(map, joint);
    const at3 = chain.map((j) => [...jointOf2(posture, j)]);
    const bones = chain.slice(0, -1).map((j) => map.lengths[j]);
    const fixed = [...at3[at3.length - 1]];
    const toward = (from, to, length, otherwise) => {
      let way3 = to.map((v, k) => v - from[k]), size = Math.hypot(...way3);
      if (size < 1e-9) [way3, size] = [otherwise, Math.hypot(...otherwise) || 1];
      return from.map((v, k) => v + length * way3[k] / size);
    };
    const before2 = at3.map((point) => [...point]);
    for (let round2 = 0; round2 < 12; round2++) {
      at3[0] = [...goal];
      for (let k = 1; k < at3.length; k++) at3[k] = toward(at3[k - 1], at3[k], bones[k - 1], [0, 1, 0]);
      at3[at3.length - 1] = [...fixed];
      for (let k = at3.length - 2; k >= 0; k--) at3[k] = toward(at3[k + 1], at3[k], bones[k], [0, 1, 0]);
    }
    const moved2 = Float64Array.from(posture);
    const turns = /* @__PURE__ */ new Map();
    chain.slice(0, -1).forEach((j, k) => {
      at3[k].forEach((v, d) => moved2[3 * j + d] = v);
      turns.set(j, turn3(before2[k].map((v, d) => v - before2[k + 1][d]), at3[k].map((v, d) => v - at3[k + 1][d])));
    });
    map.parents.forEach((parent, j) => {
      if (turns.has(j) || !turns.has(parent)) return;
      const rotate = (
        /** @type {(vector: Point) => Point} */
        turns.get(parent)
      );
      turns.set(j, rotate);
      const bone = rotate([0, 1, 2].map((d) => posture[3 * j + d] - posture[3 * parent + d]));
      bone.forEach((v, d) => moved2[3 * j + d] = moved2[3 * parent + d] + v);
    });
    return map.withBones(moved2);
  }
  function turn3(from, to) {
    const unit2 = (v) => v.map((x) => x / (Math.hypot(...v) || 1));
    const [a, b] = [unit2(from), unit2(to)];
    const axis = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    const cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const scale3 = 1 / Math.max(1 + cosine, 1e-6);
    return (v) => {
      const cross2 = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
      const once = cross2(axis, v), twice = cross2(axis, once);
      return v.map((x, k) => x + once[k] + scale3 * twice[k]);
    };
  }

  // motion_map/posture_editor.mjs
  var AXES = { front: [[1, 0, 0], [0, -1, 0]], side: [[0, 0, 1], [0, -1, 0]], top: [[1, 0, 0], [0, 0, 1]] };
  var BOX = [-1, -1.05, 2, 2.1];
  var edited2;
  var viewOf2 = (svg) => (
    /** @type {HTMLElement} */
    svg.parentNode.dataset.view ?? "front"
  );
  var NAMES = (role, name) => (role || name).replace(/_/g, " ");
  function dialog() {
    const there = (
      /** @type {HTMLDialogElement | null} */
      document.getElementById(MAP_EDITOR)
    );
    if (there) return there;
    const box4 = element("dialog", "map-editor card");
    box4.id = MAP_EDITOR;
    box4.setAttribute("aria-labelledby", MAP_EDITOR_TITLE);
    const title = element("h2", "", "Shape a posture");
    title.id = MAP_EDITOR_TITLE;
    const hint = element("p", "muted", "Drag a joint in any view, or choose one and use the arrow keys; bones keep their lengths.");
    const views = element("div", "map-editor-views");
    for (const view4 of Object.keys(AXES)) {
      const figure3 = element("figure", "map-view");
      figure3.dataset.view = view4;
      figure3.append(svgElement("svg", { viewBox: BOX.join(" "), class: "map-picture map-editor-picture" }), element("figcaption", "muted", view4));
      views.append(figure3);
    }
    const status2 = element("div", "map-editor-status number muted");
    status2.setAttribute("role", "status");
    const foot = element("div", "map-editor-foot");
    const nearest2 = element("div", "map-editor-nearest");
    const actions4 = element("div", "map-editor-actions");
    for (const [label, action, main] of [["Cancel", "cancel", ""], ["As it was", "reset", ""], ["Use as key", "use", "main"]]) {
      const button5 = element("button", `map-button ${main}`.trim(), label);
      button5.type = "button";
      button5.dataset.editor = action;
      actions4.append(button5);
    }
    foot.append(nearest2, status2, actions4);
    box4.append(title, hint, views, foot);
    need(SHELL).append(box4);
    listen2(box4);
    return box4;
  }
  function listen2(box4) {
    let held2 = null;
    const place5 = (svg, event) => {
      const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM()?.inverse());
      return [x, y];
    };
    box4.addEventListener("pointerdown", (event) => {
      const handle2 = (
        /** @type {SVGElement | null} */
        /** @type {Element | null} */
        closest(event, ".map-joint")
      );
      if (!handle2) return;
      const svg = (
        /** @type {SVGSVGElement} */
        handle2.ownerSVGElement
      );
      const joint = Number(handle2.dataset.joint);
      held2 = { svg, joint, view: viewOf2(svg), from: place5(svg, event), start: jointOf2(edited2.posture, joint) };
      edited2.joint = joint;
      svg.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    box4.addEventListener("pointermove", (event) => {
      if (!held2) return;
      const { joint, start: start3, from, svg, view: view4 } = held2;
      const [x, y] = place5(svg, event), [right, down] = AXES[view4];
      move5(joint, start3.map((v, k) => v + (x - from[0]) * right[k] + (y - from[1]) * down[k]));
    });
    box4.addEventListener("pointerup", () => {
      held2 = null;
    });
    box4.addEventListener("keydown", (event) => {
      const handle2 = (
        /** @type {SVGElement | null} */
        /** @type {Element | null} */
        closest(event, ".map-joint")
      );
      const step3 = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (!handle2 || !step3) return;
      event.preventDefault();
      event.stopPropagation();
      const view4 = viewOf2(
        /** @type {SVGSVGElement} */
        handle2.ownerSVGElement
      ), joint = Number(handle2.dataset.joint);
      const [right, down] = AXES[view4], from = jointOf2(edited2.posture, joint);
      move5(joint, from.map((v, k) => v + 0.04 * (step3[0] * right[k] + step3[1] * down[k])));
      within(box4, `[data-view="${view4}"] .map-joint[data-joint="${joint}"]`).focus();
    });
    box4.addEventListener("click", (event) => {
      const action = closest(event, "[data-editor]")?.dataset.editor;
      if (action === "cancel") box4.close();
      if (action === "reset") {
        edited2.posture = edited2.start;
        draw8();
      }
      if (action === "use") {
        const { node, key, change: change2 } = edited2, { keys } = state;
        box4.close();
        change2(key < 0 ? [...keys, node] : keys.map((old, k) => k === key ? node : old));
      }
    });
  }
  function move5(joint, goal) {
    edited2.posture = dragJoint(edited2.map, edited2.posture, joint, goal);
    draw8();
  }
  function draw8() {
    const { map, posture } = edited2, box4 = dialog();
    for (const figure3 of allWithin(box4, "[data-view]")) {
      const svg = within(figure3, "svg"), view4 = figure3.dataset.view ?? "", see = VIEWS2[view4];
      const handles = map.parents.map((_, j) => {
        const [x, y] = see(jointOf2(posture, j));
        const handle2 = svgElement("circle", { cx: x.toFixed(3), cy: y.toFixed(3), r: 0.045, class: "map-joint", tabindex: "0", role: "button", "data-joint": j });
        handle2.setAttribute("aria-label", `${NAMES(map.roles[j], map.joints[j])}, ${view4}`);
        const title = svgElement("title");
        title.textContent = NAMES(map.roles[j], map.joints[j]);
        handle2.append(title);
        return handle2;
      });
      svg.replaceChildren(drawFigure(map, posture, view4), ...handles);
    }
    const { node, distance } = map.nearest(posture);
    Object.assign(edited2, { node, distance });
    const far = distance > 2.5 * map.usual;
    within(box4, ".map-editor-status").textContent = `Nearest posture on the map: ${distance.toFixed(2)} m away${far ? ", so nothing there is like this" : ""}`;
    within(box4, ".map-editor-nearest").replaceChildren(figurePicture(map, map.posture(node), "icon"));
    state.overlay.squares("cursor", [node]);
  }
  function editPosture(node, key, change2) {
    const { map } = state;
    const posture = map.posture(node);
    edited2 = { map, posture, start: posture, key, change: change2, joint: -1, node, distance: 0 };
    dialog();
    draw8();
    dialog().showModal();
  }
  var editedPosture = () => edited2;

  // motion_map/keys.mjs
  var MOST_ROWS2 = 60;
  var AT_ONCE2 = 12;
  var button4 = (label, symbol, action, className = "map-tool") => {
    const made = element("button", className);
    made.type = "button";
    made.title = label;
    made.setAttribute("aria-label", label);
    made.append(icon(symbol));
    made.addEventListener("click", action);
    return made;
  };
  var short2 = (seconds) => (seconds >= 10 ? seconds.toFixed(0) : seconds.toFixed(1)) + " s";
  function drawPreview(map, node, facts) {
    const box4 = find(MAP_PREVIEW);
    if (!box4) return;
    if (node < 0) {
      box4.replaceChildren(element("p", "muted map-hint", "Point at the map to see a posture. Click postures in the order in which they should come."));
      return;
    }
    const posture = map.posture(node);
    const views = ["front", "side", "top"].map((view4) => {
      const figure3 = element("figure", "map-view");
      figure3.append(figurePicture(map, posture, view4), element("figcaption", "muted", view4));
      return figure3;
    });
    const row7 = element("div", "map-views");
    row7.append(...views);
    const words4 = box4.querySelector(".map-caption") || element("div", "map-caption number");
    words4.textContent = caption(map, node, facts ?? null);
    box4.replaceChildren(row7, words4);
  }
  function caption(map, node, facts) {
    const [x, y] = map.place(node);
    const labels2 = (facts && facts.labels || [])[node] || [];
    const named3 = labels2.filter(([, seconds]) => seconds >= 0.05).slice(0, 3).map(([k, seconds]) => `${facts?.names[k]} ${short2(seconds)}`).join(", ");
    const time = map.seconds[node] > 0 ? `${short2(map.seconds[node])} of motion` : "no motion here";
    return `Node ${x}, ${y} · region ${map.regions[node]} · ${time}${named3 ? ` · ${named3}` : ""}`;
  }
  function drawStrip(map, keys, change2) {
    const box4 = find(MAP_KEYS);
    if (!box4) return;
    const focused = childrenOf(box4).indexOf(
      /** @type {any} */
      document.activeElement?.closest(".map-key-card")
    );
    const move6 = (from, to) => {
      if (to < 0 || to >= keys.length || from === to) return;
      const next2 = [...keys];
      next2.splice(to, 0, ...next2.splice(from, 1));
      change2(next2, to);
    };
    const remove = (k) => change2(keys.filter((_, i) => i !== k), Math.min(k, keys.length - 2));
    box4.replaceChildren(...keys.map((node, k) => {
      const card4 = element("div", "map-key-card");
      card4.tabIndex = 0;
      card4.draggable = true;
      card4.setAttribute("role", "listitem");
      const [x, y] = map.place(node);
      card4.setAttribute("aria-label", `Key ${k + 1} of ${keys.length}, node ${x}, ${y}. Left and right move it, Delete removes it.`);
      const tools = element("div", "map-key-tools");
      tools.append(
        button4(`Move key ${k + 1} before the one in front`, "left", () => move6(k, k - 1)),
        button4(`Change the posture of key ${k + 1}`, "edit", () => editPosture(node, k, change2)),
        button4(`Move key ${k + 1} behind the next`, "right", () => move6(k, k + 1)),
        button4(`Remove key ${k + 1}`, "close", () => remove(k))
      );
      childrenOf(tools)[0].disabled = k === 0;
      childrenOf(tools)[2].disabled = k === keys.length - 1;
      card4.append(element("span", "map-key-number", String(k + 1)), figurePicture(map, map.posture(node), "icon"), tools);
      card4.addEventListener("keydown", (event) => {
        if (targetOf(event) !== card4) return;
        if (event.key === "ArrowLeft") move6(k, k - 1);
        else if (event.key === "ArrowRight") move6(k, k + 1);
        else if (event.key === "Delete" || event.key === "Backspace") remove(k);
        else return;
        event.preventDefault();
        event.stopPropagation();
      });
      card4.addEventListener("dragstart", (event) => event.dataTransfer?.setData("text/plain", String(k)));
      card4.addEventListener("dragover", (event) => event.preventDefault());
      card4.addEventListener("drop", (event) => {
        event.preventDefault();
        const from = Number.parseInt(event.dataTransfer?.getData("text/plain") ?? "", 10);
        if (Number.isInteger(from)) move6(from, k);
      });
      return card4;
    }));
    if (!keys.length) box4.append(withAttributes(element("p", "muted map-hint", "No keys yet: click a posture on the map."), { role: "listitem" }));
    if (focused >= 0) childrenOf(box4)[Math.min(focused, box4.children.length - 1)]?.focus?.({ preventScroll: true });
  }
  var hitsInWords = (n, keys) => !keys.length ? "" : n === 1 ? "1 hit" : `${n} hits`;
  function drawCount(n, keys, files) {
    const box4 = find(MAP_COUNT);
    if (box4) box4.textContent = hitsInWords(n, keys) + (n ? ` in ${files} clip${files === 1 ? "" : "s"}` : "");
  }
  var later2 = 0;
  function drawHits2(map, hits, keys, { dataset: dataset2, version, chosen: chosen3 }) {
    const box4 = find(MAP_HITS);
    if (!box4) return;
    clearTimeout(later2);
    if (!hits.length) {
      const hint = keys.length ? "Nothing passes these postures in this order. Let the keys reach farther, or remove one." : "Choose one or more postures on the map: every stretch of motion that passes through them in order is listed here.";
      box4.replaceChildren(withAttributes(element("p", "muted map-hint", hint), { role: "listitem" }));
      return;
    }
    const row7 = (hit, k) => {
      const segment = map.segment(hit);
      const { fps } = map.clips[hit.clip];
      const made = element("button", "motion-row map-hit");
      made.type = "button";
      made.dataset.store = SELECTION;
      made.dataset.value = JSON.stringify(segment);
      const on2 = chosen3 !== null && chosen3.clip === segment.clip && chosen3.start === segment.start && chosen3.end === segment.end;
      made.classList.toggle("chosen", on2);
      made.setAttribute("aria-pressed", String(on2));
      const when = `${clock(segment.start / fps)} to ${clock(segment.end / fps)}`;
      made.title = `Play ${segment.clip}, ${when}; postures ${hit.distance.toFixed(2)} m from the keys`;
      const picture2 = element("img", "motion-strip");
      const query2 = new URLSearchParams({ start: String(segment.start), end: String(segment.end), n: "5", v: version });
      const address3 = `/api/filmstrip/${encodeURIComponent(dataset2)}/${segment.clip.split("/").map(encodeURIComponent).join("/")}?${query2}`;
      Object.assign(picture2, { loading: "lazy", alt: "", draggable: false, src: address3 });
      made.append(
        element("span", "map-rank number muted", String(k + 1)),
        element("span", "ellipsis motion-clip", segment.clip),
        element("span", "muted number motion-time", when),
        picture2
      );
      return made;
    };
    box4.replaceChildren(...hits.slice(0, AT_ONCE2).map(row7));
    const rest = () => {
      box4.append(...hits.slice(AT_ONCE2, MOST_ROWS2).map((hit, k) => row7(hit, AT_ONCE2 + k)));
      if (hits.length > MOST_ROWS2) box4.append(element("div", "muted selection-more", `and ${hits.length - MOST_ROWS2} more`));
    };
    if (hits.length > AT_ONCE2) later2 = setTimeout(rest, 50);
  }
  function markHit(chosen3) {
    for (const row7 of allWithin(document, ".map-hit")) {
      const segment = JSON.parse(row7.dataset.value ?? "{}");
      const on2 = chosen3 !== null && chosen3.clip === segment.clip && chosen3.start === segment.start && chosen3.end === segment.end;
      row7.classList.toggle("chosen", on2);
      row7.setAttribute("aria-pressed", String(on2));
    }
  }

  // motion_map/link.mjs
  var MOST_KEYS = 20;
  var WAYS = ["forward", "backward", "left", "right"];
  var writeKeys = (keys, map) => keys.map((node) => map.place(node).join("-")).join(",");
  function readKeys(text, map) {
    const nodes = [];
    for (const word of String(text || "").split(",")) {
      const match = /^(\d+)-(\d+)$/.exec(word);
      if (match && Number(match[1]) < map.nx && Number(match[2]) < map.ny) nodes.push(map.index(Number(match[1]), Number(match[2])));
    }
    return nodes.slice(0, MOST_KEYS);
  }
  var readNumber = (text, otherwise) => /^\d+(\.\d+)?$/.test(text ?? "") ? Number(text) : otherwise;
  function paceOf(view4) {
    const [low, high] = String(view4.pace || "").split("-").map((word) => readNumber(word, NaN));
    const way3 = WAYS.includes(view4.way ?? "") ? view4.way : "any";
    const [slowest, fastest] = Number.isFinite(low) && Number.isFinite(high) && low <= high ? [low, high] : [0, Infinity];
    return way3 === "any" && slowest === 0 && fastest === Infinity ? null : { slowest, fastest, way: way3 };
  }

  // motion_map/overlay.mjs
  var LAYERS = ["lit", "region", "reach", "paths", "drawn", "dots", "keys", "cursor"];
  var JUMP = 3;
  var HELP = "Map of postures. Arrow keys move the cursor, Enter adds the posture under it as a key, Backspace takes the last key away.";
  var Overlay = class {
    /** @param {HTMLElement} box @param {OverlayActions} on */
    constructor(box4, on2) {
      this.box = box4;
      this.on = on2;
      this.cursor = -1;
      this.svg = svgElement("svg", { class: "map-overlay", tabindex: "0", role: "application", "aria-label": HELP });
      this.view = svgElement("svg", { preserveAspectRatio: "none", overflow: "visible" });
      this.layers = {};
      this.map = /** @type {any} */
      null;
      this.scale = 0;
      this.drawn = "";
      for (const name of LAYERS) this.view.append(this.layers[name] = svgElement("g", { class: `map-layer-${name}` }));
      this.svg.append(this.view);
      box4.append(this.svg);
      this.listen();
    }
    /** The heatmap, as Plotly has it. @returns {any} */
    get plot() {
      return this.box.querySelector(".js-plotly-plot");
    }
    /**
     * Lie exactly over the heatmap.
     * @param {MapData} map
     */
    fit(map) {
      const layout = this.plot?._fullLayout;
      if (!layout?.xaxis || !map) return;
      const { xaxis: x, yaxis: y } = layout;
      const place5 = { x: x._offset, y: y._offset, width: x._length, height: y._length, viewBox: `-0.5 -0.5 ${map.nx} ${map.ny}` };
      for (const [key, value] of Object.entries(place5)) this.view.setAttribute(key, value);
      this.scale = x._length / map.nx;
    }
    /**
     * [x, y] in node units of a pointer event; null where it is not over the map.
     * @param {PointerEvent | MouseEvent} event
     */
    at(event) {
      const matrix = this.map && this.view.getScreenCTM();
      if (!matrix) return null;
      const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.layers.cursor.getScreenCTM()?.inverse());
      return x >= -0.5 && y >= -0.5 && x < this.map.nx - 0.5 && y < this.map.ny - 0.5 ? [x, y] : null;
    }
    /** @param {PointerEvent | MouseEvent} event */
    node(event) {
      const at3 = this.at(event);
      return at3 ? this.map.index(Math.round(at3[0]), Math.round(at3[1])) : -1;
    }
    listen() {
      let drawing6 = null;
      this.svg.addEventListener("pointermove", (event) => {
        const node = this.node(event);
        if (drawing6) {
          const at3 = this.at(event), last3 = drawing6[drawing6.length - 1];
          if (at3 && Math.hypot(at3[0] - last3[0], at3[1] - last3[1]) > 0.4) drawing6.push(at3);
          this.drawPath(drawing6);
        }
        if (node >= 0 && node !== this.cursor) this.move(node);
      });
      this.svg.addEventListener("pointerdown", (event) => {
        const at3 = this.at(event);
        if (!at3 || !this.on.draws()) return;
        drawing6 = [at3];
        this.svg.setPointerCapture(event.pointerId);
      });
      this.svg.addEventListener("pointerup", () => {
        if (drawing6 && drawing6.length > 2) this.on.path(drawing6);
        drawing6 = null;
      });
      this.svg.addEventListener("click", (event) => {
        const node = this.node(event);
        if (node >= 0 && !this.on.draws()) this.on.choose(node);
      });
      this.svg.addEventListener("pointerleave", () => !drawing6 && this.on.leave());
      this.svg.addEventListener("keydown", (event) => this.key(event));
    }
    /** @param {KeyboardEvent} event */
    key(event) {
      if (!this.map || event.ctrlKey || event.metaKey || event.altKey) return;
      const steps2 = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
      const limit = (value, n) => Math.min(Math.max(value, 0), n - 1);
      const [x, y] = this.cursor < 0 ? this.map.icons[0] : this.map.place(this.cursor);
      if (steps2[event.key]) {
        const far = event.shiftKey ? 5 : 1;
        const [a, b] = this.cursor < 0 ? [0, 0] : steps2[event.key];
        this.move(this.map.index(limit(x + far * a, this.map.nx), limit(y + far * b, this.map.ny)));
      } else if (event.key === "Enter" || event.key === " ") {
        if (this.cursor >= 0) this.on.choose(this.cursor);
      } else if (event.key === "Backspace" || event.key === "Delete") this.on.undo();
      else return;
      event.preventDefault();
      event.stopPropagation();
    }
    /** @param {number} node */
    move(node) {
      this.cursor = node;
      this.squares("cursor", node < 0 ? [] : [node]);
      if (node >= 0) this.on.hover(node);
    }
    /**
     * Fill a layer with the squares of nodes, as one path.
     * @param {string} layer
     * @param {number[]} nodes
     */
    squares(layer, nodes) {
      if (!this.map) return;
      const d = nodes.map((node) => {
        const [x, y] = this.map.place(node);
        return `M${x - 0.5} ${y - 0.5}h1v1h-1z`;
      }).join("");
      this.layers[layer].replaceChildren(...d ? [svgElement("path", { d, class: `map-${layer}` })] : []);
    }
    /**
     * Nodes of every key: [{node, nodes}], numbered.
     * @param {{ node: number, nodes: number[] }[]} keys
     */
    drawKeys(keys) {
      const every = new Set(keys.flatMap((key) => key.nodes));
      this.squares("reach", [...every]);
      const size = Math.max(0.5, 9 / (this.scale || 18));
      this.layers.keys.replaceChildren(...keys.map(({ node }, k) => {
        const [x, y] = this.map.place(node);
        const mark3 = svgElement("g", { class: "map-key", transform: `translate(${x} ${y}) scale(${size.toFixed(3)})` });
        const label = svgElement("text", { y: 0.36, "text-anchor": "middle" });
        label.textContent = String(k + 1);
        mark3.append(svgElement("circle", { r: 0.9 }), label);
        return mark3;
      }));
    }
    /**
     * Ways over the map: [{points, colour}], the first drawn last; jumps over a fold of the map are thin and dotted.
     * @param {{ points: Point[], colour: string }[]} paths
     */
    drawPaths(paths) {
      this.layers.paths.replaceChildren(...[...paths].reverse().flatMap(({ points, colour }) => {
        const [ways, jumps] = [[], []];
        points.slice(1).forEach((point, k) => {
          const far = Math.hypot(point[0] - points[k][0], point[1] - points[k][1]) > JUMP;
          (far ? jumps : ways).push(`M${points[k]}L${point}`);
        });
        const made = (d, name) => svgElement("path", { d: d.join(""), class: `map-path ${name}`, style: `--tone: ${colour}` });
        return [made(jumps, "map-jump"), made(ways, "map-way")];
      }));
    }
    /** @param {Point[]} points */
    drawPath(points) {
      const line3 = points?.length > 1 ? [svgElement("polyline", { points: points.map((p) => p.map((v) => v.toFixed(2)).join(",")).join(" "), class: "map-drawn" })] : [];
      this.layers.drawn.replaceChildren(...line3);
    }
    /**
     * Where the playing figures are: [{x, y, colour}].
     * @param {Dot[]} dots
     */
    drawDots(dots) {
      const layer = this.layers.dots;
      while (layer.childElementCount > dots.length) layer.lastChild?.remove();
      while (layer.childElementCount < dots.length) layer.append(svgElement("circle", { class: "map-dot" }));
      dots.forEach(({ x, y, colour }, k) => {
        const dot3 = childrenOf(layer)[k];
        dot3.setAttribute("cx", String(x));
        dot3.setAttribute("cy", String(y));
        dot3.setAttribute("r", String(Math.max(0.3, 5.5 / (this.scale || 18))));
        dot3.style.setProperty("--tone", colour);
      });
    }
  };

  // motion_map/paths.mjs
  var TONES = ["#d1495b", "#00798c", "#edae49", "#6a4c93", "#3a7d44", "#c8553d", "#1982c4", "#8a6d3b"];
  var MOST3 = 24;
  var known2 = /* @__PURE__ */ new Map();
  var nameOf4 = (map, item) => [map.key, item.dataset, item.clip, item.start, item.end].join("\n");
  async function pathsOf(map, items) {
    const missing = items.filter((item) => !known2.has(nameOf4(map, item)));
    for (const dataset2 of new Set(missing.map((item) => item.dataset))) {
      const mine2 = missing.filter((item) => item.dataset === dataset2);
      const query2 = new URLSearchParams({ dataset: dataset2 });
      for (const { clip, start: start3, end } of mine2) for (const [key, value] of Object.entries({ clip, start: start3, end })) query2.append(key, String(value));
      const answer2 = fetch(`/api/map/${map.key}/paths?${query2}`).then((response) => response.ok ? response.json() : [], () => []);
      mine2.forEach((item, k) => known2.set(nameOf4(map, item), answer2.then((paths) => paths[k] || null)));
    }
    while (known2.size > 600) known2.delete(known2.keys().next().value);
    return Promise.all(items.map((item) => known2.get(nameOf4(map, item)) ?? null));
  }
  function along(path2, frame) {
    const at3 = Math.min(Math.max((frame - path2.start) / path2.step, 0), path2.points.length - 1);
    const k = Math.min(Math.floor(at3), path2.points.length - 2);
    if (k < 0) return path2.points[0];
    const t = at3 - k;
    return [0, 1].map((d) => path2.points[k][d] + t * (path2.points[k + 1][d] - path2.points[k][d]));
  }
  var Follower = class {
    /** @param {Overlay} overlay */
    constructor(overlay) {
      this.overlay = overlay;
      this.items = [];
      this.paths = [];
      this.dots = [];
      this.name = "";
      this.on = true;
    }
    /**
     * Take up what the Stage shows.
     * @param {MapData} map
     * @param {Followed[]} items
     */
    async take(map, items) {
      const shown9 = this.on ? items.slice(0, MOST3).map(({ dataset: dataset2, clip, start: start3, end, index }) => ({ dataset: dataset2, clip, start: start3, end, index })) : [];
      const name = JSON.stringify([map.key, shown9]);
      if (name === this.name) return;
      this.name = name;
      const paths = shown9.length ? await pathsOf(map, shown9) : [];
      if (name !== this.name) return;
      this.items = shown9;
      this.paths = paths;
      this.overlay.drawPaths(paths.flatMap((path2, k) => path2 ? [{ points: path2.points, colour: TONES[k % TONES.length] }] : []));
      this.step(items);
    }
    /**
     * Move the dots to where the figures are.
     * @param {Followed[]} items
     */
    step(items) {
      const now6 = new Map(items.map((item) => [item.index, item.frame]));
      this.dots = this.items.flatMap((item, k) => {
        const frame = now6.get(item.index), path2 = this.paths[k];
        if (frame === void 0 || !path2) return [];
        const [x, y] = along(path2, frame);
        return [{ x, y, colour: TONES[k % TONES.length] }];
      });
      this.overlay.drawDots(this.dots);
    }
  };

  // motion_map/map.mjs
  var USUAL2 = { colour: "height", click: "keys", pace: "any", way: "any" };
  var DRAWN_KEYS = ["colour", "below", "region"];
  var keyOf2 = (id) => (
    /** @type {ViewKey} */
    id.slice("map-".length)
  );
  var live = 0;
  var page = () => find(MAP_PLOT);
  function drawKeys() {
    const { map, keys, reach } = state;
    state.overlay.drawKeys(keys.map((node) => {
      const apart = map.distances(node), nodes = [];
      for (let k = 0; k < map.n; k++) if (k === node || apart[k] < reach) nodes.push(k);
      return { node, nodes };
    }));
  }
  function search() {
    const { map, keys, reach, pace, path: path2 } = state;
    if (!path2) state.hits = map.search(keys, reach, pace);
    drawCount(state.hits.length, path2 ? [path2] : keys, new Set(state.hits.map((hit) => hit.clip)).size);
    const all = find(MAP_PLAY_ALL);
    if (all) all.disabled = state.hits.length === 0;
    return state.hits;
  }
  function list2() {
    const { dataset: dataset2, version } = state.known;
    drawHits2(state.map, state.hits, state.keys, { dataset: dataset2, version, chosen: state.selection });
  }
  function refresh2(lists2 = true) {
    if (!state.map || !state.overlay) return;
    drawKeys();
    search();
    clearTimeout(live);
    if (lists2) list2();
    else live = setTimeout(list2, 120);
  }
  async function ask4(address3) {
    const answer2 = await fetch(address3).catch(() => null);
    const body2 = await answer2?.json().catch(() => null);
    return answer2?.ok && body2 ? body2 : { error: body2?.error || "The server does not answer; try again in a moment." };
  }
  async function followPath(path2) {
    const { map } = state;
    state.path = path2;
    state.overlay.drawPath(path2.split(",").map((point) => point.split("-").map(Number)));
    const answer2 = await ask4(`/api/map/${map.key}/drawn?${new URLSearchParams({ path: path2 })}`);
    if (state.path !== path2 || state.map !== map) return;
    if (answer2.error) notify("This path was not followed", answer2.error);
    state.hits = answer2.error ? [] : answer2;
    refresh2();
  }
  function drawn4(points) {
    const step3 = Math.max(1, Math.ceil(points.length / 24));
    const few = points.filter((_, k) => k % step3 === 0 || k === points.length - 1);
    const path2 = few.map((point) => point.map((value) => Math.max(value, 0).toFixed(1)).join("-")).join(",");
    state.keys = [];
    drawStrip(state.map, [], setKeys);
    changeView({ drawn: path2, keys: "" });
    return followPath(path2);
  }
  function setKeys(keys, focus2) {
    if (state.path) {
      state.path = "";
      state.overlay.drawPath([]);
    }
    state.keys = keys.slice(0, 20);
    drawStrip(state.map, state.keys, setKeys);
    if (focus2 !== void 0) childrenOf(need(MAP_KEYS))[focus2]?.focus();
    refresh2();
    changeView({ keys: writeKeys(state.keys, state.map), drawn: "" });
  }
  function setReach(reach, done) {
    state.reach = reach;
    showReach();
    refresh2(done);
    if (done) changeView({ within: reach ? reach.toFixed(2) : "" });
  }
  function showReach() {
    const slider2 = find(MAP_REACH), label = find(MAP_REACH_VALUE);
    if (!slider2 || !label || !state.map) return;
    slider2.max = String(state.map.reach);
    slider2.value = String(state.reach);
    slider2.setAttribute("aria-valuetext", `${state.reach.toFixed(2)} metres`);
    label.textContent = `${state.reach.toFixed(2)} m`;
  }
  function choose4(node) {
    if (state.mode === "regions") {
      const region = state.map.regions[node];
      changeView({ region: String(region), below: "region" });
    } else setKeys([...state.keys, node]);
  }
  function mount2() {
    const box4 = page();
    if (!box4 || state.overlay?.box === box4) return Boolean(box4);
    state.overlay = new Overlay(box4, {
      /** @param {number} node */
      hover: (node) => drawPreview(state.map, node, state.facts),
      leave: () => {
      },
      choose: choose4,
      undo: () => state.keys.length && setKeys(state.keys.slice(0, -1)),
      draws: () => state.mode === "draw",
      path: drawn4
    });
    state.follower = new Follower(state.overlay);
    const slider2 = Object.assign(document.createElement("input"), { type: "range", id: MAP_REACH, className: "map-slider", min: 0, step: 0.01, value: 0 });
    slider2.setAttribute("aria-labelledby", MAP_REACH_LABEL);
    need(MAP_REACH_BOX).replaceChildren(slider2);
    slider2.addEventListener("input", () => state.map && setReach(Number(slider2.value), false));
    slider2.addEventListener("change", () => state.map && setReach(Number(slider2.value), true));
    new ResizeObserver(() => requestAnimationFrame(fit)).observe(box4);
    return true;
  }
  function fit() {
    if (!state.overlay || !state.map) return;
    state.overlay.fit(state.map);
    drawKeys();
  }
  function show5(view4) {
    const { map } = state;
    if (!map || !mount2()) return;
    const keys = readKeys(view4.keys, map), reach = Math.min(readNumber(view4.within, 0), map.reach), pace = paceOf(view4);
    state.mode = view4.click === "regions" || view4.click === "draw" ? view4.click : "keys";
    need(MAP_PLOT).dataset.mode = state.mode;
    const region = readNumber(view4.region, -1);
    state.overlay.squares("region", region < 0 ? [] : [...map.regions.keys()].filter((node) => map.regions[node] === region));
    const path2 = view4.drawn || "";
    const shown9 = JSON.stringify([keys, reach, pace, path2]);
    if (shown9 === JSON.stringify([state.keys, state.reach, state.pace, state.path]) && state.shownOn === map.key) return;
    const stays = path2 && path2 === state.path && state.shownOn === map.key;
    Object.assign(state, { keys, reach, pace, shownOn: map.key });
    showReach();
    drawStrip(map, keys, setKeys);
    if (path2 && !stays) followPath(path2);
    else {
      state.path = path2;
      if (!path2) state.overlay.drawPath([]);
      refresh2();
    }
  }
  window.addEventListener("stage-state", (event) => {
    if (state.map && state.follower && page()) state.follower.take(state.map, own(event.detail.items));
  });
  window.addEventListener("stage-frame", (event) => {
    if (state.map && state.follower && page() && event.detail.items) state.follower.step(own(event.detail.items));
  });
  var own = (items) => (items || []).map((item) => ({ ...item, dataset: item.dataset || state.known?.dataset || "" }));
  async function keyFromStage() {
    const item = player.frameOf(0);
    if (!item) return notify("Nothing is on the Stage", "Play a clip or a motif first; its current frame then becomes a key.");
    const query2 = new URLSearchParams({ dataset: item.dataset || state.known.dataset, clip: item.clip, frame: String(item.frame) });
    const answer2 = await ask4(`/api/map/${state.map.key}/node?${query2}`);
    if (answer2.error) return notify("That posture cannot be a key", answer2.error);
    const node = state.map.index(answer2.node[0], answer2.node[1]);
    state.overlay.move(node);
    setKeys([...state.keys, node]);
    if (answer2.distance > 2.5 * answer2.usual) notify("Added, but it fits badly", `No posture of the map is like this one: the nearest is ${answer2.distance.toFixed(2)} m away, ${answer2.usual.toFixed(2)} m is usual.`);
  }
  function playAll() {
    const items = state.hits.slice(0, 12).map((hit) => {
      const segment = state.map.segment(hit);
      return { ...segment, label: segment.clip };
    });
    if (!items.length) return;
    const { dataset: dataset2, version } = state.known;
    const title = `${items.length} of ${state.hits.length} hits`;
    const request5 = { dataset: dataset2, version, items, title, layout: "overlay", sync: "start" };
    setStore(STAGE_REQUEST, request5);
    player.show(request5);
  }
  document.addEventListener("click", (event) => {
    const button5 = closest(event, "[data-map-do]");
    if (!button5 || !state.map) return;
    const actions4 = {
      stage: keyFromStage,
      all: playAll,
      clear: () => setKeys([]),
      edit: () => editPosture(state.overlay.cursor >= 0 ? state.overlay.cursor : state.map.index(...state.map.icons[0]), -1, setKeys)
    };
    actions4[button5.dataset.mapDo ?? ""]?.();
  });
  register("map", {
    /**
     * A map has come: fetch it, then show what the link says of it.
     * @param {KnownMap | null} known
     * @param {View | null} view
     */
    async load(known4, view4) {
      if (!known4 || !known4.key) {
        state.map = /** @type {any} */
        null;
        return clientside.no_update;
      }
      const map = await loadMap(known4.key).catch(() => null);
      if (!map) return clientside.no_update;
      Object.assign(state, { map, known: known4, facts: known4.facts });
      if (!mount2()) return clientside.no_update;
      state.overlay.map = map;
      state.overlay.cursor = -1;
      drawPreview(map, -1);
      state.shownOn = null;
      show5(view4 || {});
      fit();
      state.overlay.squares("lit", state.lit);
      state.follower.take(map, own(player.standing()));
      return map.key;
    },
    /** @param {View | null} view */
    view(view4) {
      show5(view4 || {});
      return clientside.no_update;
    },
    /** The heatmap was drawn anew: lie over it again. */
    drawn() {
      requestAnimationFrame(() => requestAnimationFrame(fit));
      return clientside.no_update;
    },
    /** @param {{ nodes?: number[] } | null} lit */
    lit(lit4) {
      state.lit = lit4 && lit4.nodes || [];
      if (state.overlay && state.map) state.overlay.squares("lit", state.lit);
      return clientside.no_update;
    },
    /** @param {Selection | null} selection */
    selection(selection) {
      state.selection = selection && selection.clip !== void 0 ? selection : null;
      markHit(state.selection);
      return clientside.no_update;
    },
    /**
     * A control was used: its choice goes into the link, the usual one leaves it.
     * @param {string | null} value
     * @param {View | null} view
     */
    chosen(value, view4) {
      const key = keyOf2(clientside.callback_context.inputs_list[0].id);
      const wanted2 = value === USUAL2[key] ? "" : value ?? "";
      if (value && (view4?.[key] || "") !== wanted2) changeView({ [key]: wanted2 });
      return clientside.no_update;
    },
    /** @param {View | null} view @param {string} id */
    choice(view4, id) {
      const key = keyOf2(id);
      return view4?.[key] || USUAL2[key];
    },
    /** Those parts of the view that the server draws by. @param {View | null} view @param {View | null} current */
    look(view4, current3) {
      const next2 = Object.fromEntries(DRAWN_KEYS.filter((key) => view4?.[key]).map((key) => [key, view4?.[key]]));
      return current3 && JSON.stringify(next2) === JSON.stringify(current3) ? clientside.no_update : next2;
    }
  });

  // search/state.mjs
  var none2 = null;
  var now5 = {
    found: (
      /** @type {Found} */
      none2
    ),
    view: (
      /** @type {View} */
      {}
    ),
    clips: (
      /** @type {ClipList} */
      none2
    ),
    motifs: (
      /** @type {MotifQuery[]} */
      []
    ),
    scheme: "light",
    presets: (
      /** @type {Record<string, Weights>} */
      {}
    ),
    body: (
      /** @type {Body} */
      none2
    ),
    engines: (
      /** @type {any[]} */
      []
    ),
    key: (
      /** @type {any} */
      null
    ),
    selection: (
      /** @type {Selection} */
      {}
    ),
    active: 0
  };
  var changeSearch = (values) => changeView({ hit: "", ...values });
  var bytes = new TextEncoder();
  var escapeName = (name) => [...name].map((c) => /[-0-9A-Za-z._ ]/.test(c) ? c : [...bytes.encode(c)].map((byte) => "~" + byte.toString(16).padStart(2, "0")).join("")).join("");
  var nodesOf = (leaves) => {
    const wanted2 = new Set(leaves);
    const nodes = [];
    const left = new Set(leaves);
    for (const [node, below] of Object.entries(now5.body.nodes)) {
      if (below.every((leaf) => wanted2.has(leaf)) && below.some((leaf) => left.has(leaf))) {
        nodes.push(node);
        below.forEach((leaf) => left.delete(leaf));
      }
    }
    return nodes;
  };
  var writeQuery = (pieces) => pieces.filter((piece) => piece.leaves.length).map((piece) => [
    ...piece.leaves.length === now5.body.leaves.length ? [] : [nodesOf(piece.leaves).join("+")],
    escapeName(piece.clip),
    `${piece.start}-${piece.end}`,
    ...piece.dataset ? [escapeName(piece.dataset)] : []
  ].join(":")).join(",");
  var copyPieces = () => (now5.found && now5.found.pieces || []).map((piece) => ({ ...piece, leaves: [...piece.leaves] }));
  var searchFor = (pieces, more2 = {}) => {
    const query2 = writeQuery(pieces);
    if (query2 !== (now5.view.query || "")) remember4();
    changeSearch({ query: query2, ...more2 });
  };
  var before = [];
  var remember4 = () => {
    const { query: query2, parts: weights } = now5.view;
    if (query2 && (!before.length || before.at(-1)?.query !== query2)) before.push({ query: query2, parts: weights || "" });
    if (before.length > 30) before.shift();
  };
  var goBack = () => {
    while (before.length) {
      const last3 = before.pop();
      if (last3 && last3.query !== now5.view.query) return changeSearch(last3);
    }
    return void 0;
  };
  var canGoBack = () => before.some((one) => one.query !== now5.view.query);
  var searchAddress = (hit) => {
    const pairs = new URLSearchParams({ dataset: now5.clips.dataset, v: now5.clips.version.slice(0, 8) });
    for (const [key, value] of Object.entries(now5.view)) {
      if (value && (["query", "parts"].includes(key) || key.startsWith("search-"))) pairs.set(key, value);
    }
    if (hit) pairs.set("hit", hit);
    return pairs.toString();
  };

  // search/weights.mjs
  var EVEN = 10;
  var evenWeights = (body2) => Object.fromEntries(body2.leaves.map((leaf) => [leaf, EVEN]));
  function readWeights(text, body2) {
    const weights = Object.fromEntries(body2.leaves.map((leaf) => [leaf, 0]));
    let total3 = 0;
    for (const word of (text || "").split(",")) {
      const [node, weight] = word.split(":");
      const leaves = body2.nodes[node];
      if (!leaves || !(Number(weight) > 0)) continue;
      for (const leaf of leaves) weights[leaf] += Number(weight) / leaves.length;
      total3 += Number(weight);
    }
    return total3 ? weights : evenWeights(body2);
  }
  function writeWeights(weights, body2) {
    const values = Object.values(weights);
    if (values.every((value) => value === values[0])) return "";
    return body2.leaves.filter((leaf) => weights[leaf] > 0).map((leaf) => `${leaf}:${Number(weights[leaf].toFixed(2))}`).join(",");
  }
  var total = (weights) => Object.values(weights).reduce((sum2, value) => sum2 + value, 0) || 1;
  function sameWeights(a, b, body2) {
    const [sumA, sumB] = [total(a), total(b)];
    return body2.leaves.every((leaf) => Math.abs((a[leaf] || 0) / sumA - (b[leaf] || 0) / sumB) < 2e-3);
  }

  // search/body.mjs
  var MOST4 = 50;
  var SHAPES = {
    torso: ["M48 44 Q60 39 72 44 L69 74 L71 92 Q60 97 49 92 L51 74 Z"],
    head: ["M60 8 a12.5 13.500 0 1 1 -.01 0 Z"],
    left_arm: ["M80 49 L91 76"],
    left_hand: ["M93.500 84 L97.500 104"],
    right_arm: ["M40 49 L29 76"],
    right_hand: ["M26.500 84 L22.500 104"],
    left_leg: ["M67.500 103 L70.500 144"],
    left_foot: ["M71.500 154 L72 170 L79 174"],
    right_leg: ["M52.500 103 L49.500 144"],
    right_foot: ["M48.500 154 L48 170 L41 174"]
  };
  var THICK = { left_arm: 11, right_arm: 11, left_hand: 9, right_hand: 9, left_leg: 14, right_leg: 14, left_foot: 10, right_foot: 10 };
  var assigning = () => Boolean(now5.found && now5.found.pieces && now5.found.pieces.length > 1) && mode2 === "pieces";
  var mode2 = "weights";
  var raw = (
    /** @type {any} */
    null
  );
  var drawn5 = "";
  var waiting2 = 0;
  var total2 = () => Object.values(raw).reduce((sum2, value) => sum2 + value, 0);
  var share = (leaf) => raw[leaf] / Math.max(total2(), 1e-9);
  var percent2 = (value) => value === 0 ? "0 %" : `${(100 * value).toFixed(100 * value < 9.95 ? 1 : 0)} %`.replace(".0 ", " ");
  function send2() {
    clearTimeout(waiting2);
    waiting2 = setTimeout(() => {
      waiting2 = 0;
      if (total2() > 0) changeSearch({ parts: writeWeights(raw, now5.body) });
    }, 140);
  }
  function put2(leaf, value) {
    raw[leaf] = Math.min(Math.max(value, 0), MOST4);
    paint();
    need(SEARCH_BODY).classList.toggle("search-none", total2() === 0);
    send2();
  }
  function shape(leaf) {
    const group = svgElement("g");
    group.setAttribute("class", "search-part");
    group.setAttribute("tabindex", "0");
    group.dataset.part = leaf;
    for (const d of SHAPES[leaf]) {
      const path2 = svgElement("path");
      path2.setAttribute("d", d);
      if (THICK[leaf]) {
        path2.setAttribute("fill", "none");
        path2.setAttribute("stroke-width", String(THICK[leaf]));
        path2.setAttribute("class", "search-limb");
      }
      group.append(path2);
    }
    const title = svgElement("title");
    group.append(title);
    return group;
  }
  function figure2() {
    const svg = svgElement("svg");
    svg.setAttribute("viewBox", "10 4 100 178");
    svg.setAttribute("class", "search-figure");
    svg.setAttribute("role", "group");
    svg.setAttribute("aria-label", "Parts of the body, seen from the front");
    const order = ["torso", ...now5.body.leaves.filter((leaf) => leaf !== "torso")];
    svg.append(...order.map(shape));
    for (
      const [letter, x] of
      /** @type {[string, number][]} */
      [["R", 17], ["L", 103]]
    ) {
      const text = svgElement("text");
      text.setAttribute("x", String(x));
      text.setAttribute("y", String(40));
      text.setAttribute("class", "search-side");
      text.textContent = letter;
      text.append(svgElement("title", {}, letter === "L" ? "Their left" : "Their right"));
      svg.append(text);
    }
    return svg;
  }
  function slider(leaf) {
    const input2 = element("input", "search-weight");
    Object.assign(input2, { type: "range", min: 0, max: MOST4, step: 0.5 });
    input2.dataset.weight = leaf;
    input2.setAttribute("aria-label", `Weight of the ${now5.body.words[leaf].toLowerCase()}`);
    const label = element("span", "search-weight-name", now5.body.words[leaf]);
    const line3 = element("label", "search-weight-row", label, input2, element("span", "search-weight-share number"));
    line3.dataset.part = leaf;
    return line3;
  }
  function build(box4) {
    const presets = element("select", "search-select");
    presets.id = SEARCH_PRESET;
    presets.setAttribute("aria-label", "Ready-made weights");
    const names2 = Object.keys(now5.presets);
    presets.append(...names2.map((name) => {
      const option2 = element("option", "", name[0].toUpperCase() + name.slice(1));
      option2.value = name;
      return option2;
    }), Object.assign(element("option", "", "Weights of your own"), { value: "", hidden: true }));
    const modes = element("div", "search-modes hidden");
    modes.setAttribute("role", "radiogroup");
    modes.setAttribute("aria-label", "What a click in the figure does");
    for (const [value, words4] of [["weights", "Weigh"], ["pieces", "Assign"]]) {
      const one = element("button", "search-mode", words4);
      one.type = "button";
      one.dataset.mode = value;
      one.setAttribute("role", "radio");
      modes.append(one);
    }
    const hint = element("p", "muted search-body-hint");
    const left = element("div", "search-body-left", figure2(), modes);
    const right = element("div", "search-body-right", presets, element("div", "search-weights", ...now5.body.leaves.map(slider)), hint);
    box4.replaceChildren(left, right);
  }
  function paint() {
    const box4 = need(SEARCH_BODY);
    const pieces = now5.found && now5.found.pieces || [];
    const owner = (leaf) => pieces.findIndex((piece) => piece.leaves.includes(leaf));
    const several = pieces.length > 1;
    const most = Math.max(...Object.values(raw), 1e-9);
    within(box4, ".search-modes").classList.toggle("hidden", !several);
    for (const one of allWithin(box4, "[data-mode]")) one.setAttribute("aria-checked", String(one.dataset.mode === mode2));
    for (const group of allWithin(box4, ".search-part")) {
      const leaf = group.dataset.part ?? "";
      const own2 = owner(leaf);
      const colour = several ? own2 >= 0 ? pieces[own2].colour : "var(--muted)" : "var(--accent)";
      const strength = assigning() ? own2 >= 0 ? 0.85 : 0.1 : raw[leaf] > 0 ? 0.25 + 0.75 * Math.sqrt(raw[leaf] / most) : 0;
      group.style.setProperty("--tone", colour);
      group.style.setProperty("--strength", `${Math.round(100 * strength)}%`);
      group.classList.toggle("off", strength === 0);
      const says = assigning() ? own2 >= 0 ? `from ${"ABCDEF"[own2]}` : "from none" : percent2(share(leaf));
      group.setAttribute("aria-label", now5.body.words[leaf]);
      group.setAttribute("role", assigning() ? "button" : "slider");
      if (assigning()) {
        for (const name of ["aria-valuenow", "aria-valuemin", "aria-valuemax", "aria-valuetext"]) group.removeAttribute(name);
        group.setAttribute("aria-label", `${now5.body.words[leaf]}: ${says}`);
      } else {
        group.setAttribute("aria-valuemin", String(0));
        group.setAttribute("aria-valuemax", String(100));
        group.setAttribute("aria-valuenow", String(Math.round(100 * share(leaf))));
        group.setAttribute("aria-valuetext", says);
      }
      within(group, "title").textContent = `${now5.body.words[leaf]}: ${says}`;
    }
    for (const row7 of allWithin(box4, ".search-weight-row")) {
      const leaf = row7.dataset.part ?? "";
      const input2 = within(row7, "input");
      if (Number(input2.value) !== raw[leaf]) input2.value = String(raw[leaf]);
      input2.style.setProperty("--share", `${100 * raw[leaf] / MOST4}%`);
      input2.setAttribute("aria-valuetext", percent2(share(leaf)));
      within(row7, ".search-weight-share").textContent = percent2(share(leaf));
      row7.classList.toggle("off", raw[leaf] === 0);
      const own2 = owner(leaf);
      row7.style.setProperty("--tone", several && own2 >= 0 ? pieces[own2].colour : "var(--accent)");
    }
    const named3 = Object.entries(now5.presets).find(([, weights]) => sameWeights(weights, raw, now5.body));
    within(box4, `#${SEARCH_PRESET}`).value = named3 ? named3[0] : "";
    within(box4, ".search-body-hint").textContent = total2() === 0 ? "All parts are off: switch on at least one." : assigning() ? `Click parts to take them from ${"ABCDEF"[now5.active]}. Shift + click: the whole limb.` : "Click a part to switch it on or off, Shift + click for this one alone; arrow keys change its weight.";
  }
  var drawBody = () => {
    const box4 = find(SEARCH_BODY);
    if (!box4) return;
    if (!box4.firstChild) {
      build(box4);
      drawn5 = "";
    }
    const pieces = now5.found && now5.found.pieces || [];
    if (pieces.length < 2) mode2 = "weights";
    else if (pieces.length !== Number(box4.dataset.pieces || 0)) mode2 = "pieces";
    box4.dataset.pieces = String(pieces.length);
    const text = now5.view.parts || "";
    if (!raw || text !== drawn5 && !waiting2) {
      raw = readWeights(text, now5.body);
      drawn5 = text;
    }
    paint();
  };
  var counts = (leaf) => {
    const weights = readWeights(now5.view.parts, now5.body);
    return weights[leaf] > 0 && now5.found.pieces.some((piece) => piece.leaves.includes(leaf));
  };
  var lightPart = (leaf) => {
    for (const one of allWithin(document, ".search-page [data-part]")) one.classList.toggle("lit", one.dataset.part === leaf);
  };
  var LIMBS = ["head_torso", "left_arm_hand", "right_arm_hand", "left_leg_foot", "right_leg_foot"];
  var limbOf = (leaf) => now5.body.nodes[LIMBS.find((node) => now5.body.nodes[node].includes(leaf)) ?? ""];
  function assign2(leaves) {
    const pieces = copyPieces();
    const taker = pieces[now5.active];
    if (!taker) return;
    const has = leaves.every((leaf) => taker.leaves.includes(leaf));
    for (const piece of pieces) piece.leaves = piece.leaves.filter((leaf) => !leaves.includes(leaf));
    if (!has) taker.leaves = now5.body.leaves.filter((leaf) => taker.leaves.includes(leaf) || leaves.includes(leaf));
    if (pieces.every((piece) => !piece.leaves.length)) return;
    if (pieces.some((piece) => !piece.leaves.length)) now5.active = 0;
    searchFor(pieces);
  }
  function press3(leaf, shift) {
    if (assigning()) return assign2(shift ? limbOf(leaf) : [leaf]);
    if (shift) {
      raw = Object.fromEntries(now5.body.leaves.map((one) => [one, one === leaf ? EVEN : 0]));
      return put2(leaf, EVEN);
    }
    return put2(leaf, raw[leaf] > 0 ? 0 : Math.max(...Object.values(raw)) || EVEN);
  }
  document.addEventListener("click", (event) => {
    const part2 = closest(event, ".search-part");
    if (part2) press3(part2.dataset.part ?? "", event.shiftKey);
    const chosen3 = closest(event, "[data-mode]");
    if (chosen3 && chosen3.closest(`#${SEARCH_BODY}`)) {
      mode2 = chosen3.dataset.mode ?? "weights";
      paint();
    }
  });
  document.addEventListener("keydown", (event) => {
    const part2 = closest(event, ".search-part");
    if (!part2) return;
    const leaf = part2.dataset.part ?? "";
    const step3 = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[event.key];
    if (event.key === "Enter" || event.key === " ") press3(leaf, event.shiftKey);
    else if (step3 && !assigning()) put2(leaf, raw[leaf] + step3);
    else if (event.key === "Home" && !assigning()) put2(leaf, 0);
    else if (event.key === "End" && !assigning()) put2(leaf, MOST4);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  document.addEventListener("input", (event) => {
    const { dataset: dataset2, value } = targetOf(event);
    if (dataset2?.weight) put2(dataset2.weight, Number(value));
  });
  document.addEventListener("change", (event) => {
    if (targetOf(event).id !== SEARCH_PRESET || !targetOf(event).value) return;
    const weights = now5.presets[targetOf(event).value];
    const scale3 = targetOf(event).value === "whole body" ? 100 : Math.min(100, MOST4 / Math.max(...Object.values(weights)));
    raw = Object.fromEntries(now5.body.leaves.map((leaf) => [leaf, scale3 * (weights[leaf] || 0)]));
    if (targetOf(event).value === "whole body") raw = evenWeights(now5.body);
    paint();
    send2();
  });
  for (const kind of ["pointerover", "focusin"]) {
    document.addEventListener(kind, (event) => {
      const page2 = closest(event, ".search-page");
      if (!page2) return;
      const part2 = closest(event, "[data-part]");
      lightPart(part2 ? part2.dataset.part : null);
    });
  }

  // search/strip.mjs
  function paintStrip(canvas, strip) {
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((size) => Math.max(1, Math.round(size * ratio)));
    canvas.width = width;
    canvas.height = height;
    const context = context2d(canvas);
    const style = getComputedStyle(canvas);
    const [full, dull] = [style.getPropertyValue("--strip-full").trim(), style.getPropertyValue("--strip-dull").trim()];
    const rows2 = strip.rows.length;
    strip.rows.forEach((cells, r) => {
      const strength = counts(now5.body.leaves[r]) ? 1 : 0.3;
      const [top, bottom] = [Math.round(r * height / rows2), Math.round((r + 1) * height / rows2) - Math.max(1, Math.round(ratio / 2))];
      cells.forEach((value, c) => {
        if (value < 0) return;
        const [left, right] = [Math.floor(c * width / cells.length), Math.floor((c + 1) * width / cells.length)];
        context.globalAlpha = strength;
        context.fillStyle = dull;
        context.fillRect(left, top, right - left, bottom - top);
        context.globalAlpha = strength * (value / 100) ** 1.5;
        context.fillStyle = full;
        context.fillRect(left, top, right - left, bottom - top);
      });
    });
  }
  var canvasOf = (row7) => (
    /** @type {HTMLCanvasElement} */
    row7.querySelector("canvas")
  );

  // search/words.mjs
  var scoreWords = (score, chances) => {
    if (!chances) return score.toFixed(3);
    if (score < 0.01) return "< 1 %";
    return score >= 0.995 && score < 0.9999 ? "> 99 %" : `${Math.round(100 * score)} %`;
  };

  // search/hits.mjs
  var MORE = 30;
  var reasons = /* @__PURE__ */ new Map();
  var known3 = /* @__PURE__ */ new Map();
  var reasonOf = (name) => {
    const address3 = `/api/search/explain?${searchAddress(name)}`;
    if (!reasons.has(address3)) {
      const answer2 = fetch(address3).then(async (response) => {
        const body2 = await response.json().catch(() => ({}));
        if (!response.ok) throw new Error(body2.error || "The server does not answer.");
        known3.set(address3, body2);
        return body2;
      });
      answer2.catch(() => reasons.delete(address3));
      reasons.set(address3, answer2);
      if (reasons.size > 400) for (const old of [...reasons.keys()].slice(0, 100)) {
        reasons.delete(old);
        known3.delete(old);
      }
    }
    return (
      /** @type {Promise<Reason>} */
      reasons.get(address3)
    );
  };
  var reasonNow = (name) => known3.get(`/api/search/explain?${searchAddress(name)}`);
  function drawStrip2(row7) {
    const canvas = canvasOf(row7);
    const name = row7.dataset.hit ?? "";
    reasonOf(name).then(({ strip }) => {
      if (!canvas.isConnected) return;
      paintStrip(canvas, strip);
      row7.strip = strip;
      row7.classList.add("explained");
      const best = now5.body.leaves.map((leaf, k) => (
        /** @type {[number, string]} */
        [strip.means[k] ?? -1, now5.body.words[leaf].toLowerCase()]
      )).filter(([mean]) => mean >= 0).sort((a, b) => b[0] - a[0]);
      if (best.length) canvas.setAttribute("aria-label", `Most alike: ${best.slice(0, 3).map(([mean, words4]) => `${words4} ${Math.round(100 * mean)} %`).join(", ")}`);
    }, (error) => {
      if (canvas.isConnected) canvas.title = error.message;
    });
  }
  var seen2 = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target: target2 } of entries) {
      if (!isIntersecting) continue;
      seen2.unobserve(target2);
      drawStrip2(
        /** @type {HitRow} */
        target2
      );
    }
  }, { rootMargin: "120px" });
  function describe2(event) {
    const row7 = (
      /** @type {HitRow | null} */
      closest(event, ".search-hit")
    );
    if (!row7 || !row7.strip) return;
    const box4 = targetOf(event).getBoundingClientRect();
    const leaf = Math.min(Math.floor((event.clientY - box4.top) / box4.height * 10), 9);
    const cells = row7.strip.rows[leaf];
    const share2 = Math.min(Math.max((event.clientX - box4.left) / box4.width, 0), 0.9999);
    const value = cells[Math.floor(share2 * cells.length)];
    const lead = now5.found.pieces[0];
    const when = `${(share2 * (lead.end - lead.start) / lead.fps).toFixed(1)} s`;
    targetOf(event).title = `${now5.body.words[now5.body.leaves[leaf]]}, ${when} into the query: ${value < 0 ? "not compared" : `${value} % alike`}`;
    lightPart(now5.body.leaves[leaf]);
  }
  function link(symbol, words4, href) {
    const made = element("a", "search-tool", icon(symbol));
    Object.assign(made, { href, title: words4 });
    made.setAttribute("aria-label", words4);
    return made;
  }
  function hitRow(hit, chances) {
    const made = element("div", "search-hit");
    made.setAttribute("role", "listitem");
    made.dataset.hit = hit.name;
    const picture2 = element("img", "search-strip");
    Object.assign(picture2, { src: hit.strip, alt: "", loading: "lazy", draggable: false });
    const bar = element("span", "search-score-bar");
    bar.style.setProperty("--share", String(Math.min(Math.max(hit.score, 0), 1)));
    const score = element("span", "search-score", bar, element("b", "number", scoreWords(hit.score, chances)));
    if (chances) score.title = "The chance that people would call this the same action";
    const facts = element("span", "search-facts muted", [hit.when, hit.label].filter(Boolean).join(" · "));
    const words4 = element("span", "search-words", element("span", "search-name ellipsis", hit.clip), facts, score);
    const open6 = element("button", "search-open", element("span", "search-rank number", String(hit.rank)), picture2, words4);
    open6.type = "button";
    open6.title = `Compare with the query on the Stage: ${hit.clip}, frames ${hit.start} to ${hit.end}`;
    const canvas = element("canvas", "search-why");
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "Which parts match when");
    const similar = element("button", "search-tool", icon("search"));
    similar.type = "button";
    similar.title = "More like this";
    similar.setAttribute("aria-label", `More like ${hit.clip}`);
    similar.dataset.similar = JSON.stringify({ clip: hit.clip, start: hit.start, end: hit.end });
    const bvh = link(
      "download",
      "Save as BVH",
      `/api/bvh/${encodeURIComponent(now5.clips.dataset)}/${encodeURIComponent(hit.clip)}?start=${hit.start}&end=${hit.end}`
    );
    const why = element("div", "search-why-box", element("div", "search-why-names"), canvas, element("div", "search-why-cursor"));
    made.append(open6, why, element("div", "search-hit-tools", similar, bvh));
    return made;
  }
  var took = (ms) => ms < 10 ? `${ms.toFixed(1)} ms` : ms < 2e3 ? `${Math.round(ms)} ms` : `${(ms / 1e3).toFixed(1)} s`;
  function head2(box4, found) {
    const { total: total3, hits, milliseconds } = found;
    const count = hits.length < total3 ? `${hits.length} of ${total3}` : `${total3}`;
    const noun = found.level === "clip" ? "clip" : "moment";
    const others = found.unlike ? `; ${found.unlike} more are unlike it` : "";
    box4.replaceChildren(
      element("h2", "", "Hits"),
      element("span", "muted number", `${count} ${noun}${total3 === 1 ? "" : "s"}, found in ${took(milliseconds)}${others}`),
      element("span", "spacer"),
      element("span", "search-key muted", "which parts match when: ", element("i", "search-key-none"), " not at all", element("i", "search-key-full"), " alike")
    );
  }
  var drawn6 = "";
  var drawHits3 = () => {
    const box4 = find(SEARCH_HITS);
    if (!box4) return;
    const title = need(SEARCH_HITS_HEAD), error = need(SEARCH_ERROR);
    const found = now5.found || {};
    error.textContent = found.error || "";
    error.classList.toggle("hidden", !found.error);
    const ready2 = Boolean(found.hits);
    box4.classList.toggle("hidden", !ready2);
    title.classList.toggle("hidden", !ready2);
    if (!ready2) {
      drawn6 = "";
      box4.replaceChildren();
      return;
    }
    const mark3 = JSON.stringify([found.inputs, now5.scheme]);
    if (mark3 !== drawn6 || !box4.firstChild) {
      drawn6 = mark3;
      head2(title, found);
      const rows2 = found.hits.map((hit) => hitRow(hit, Boolean(found.chances)));
      box4.replaceChildren(...rows2);
      if (!rows2.length) box4.append(element("p", "muted search-nothing", nothing2(found)));
      for (const one of rows2) seen2.observe(one);
      if (found.hits.length < found.total && found.hits.length < 300) box4.append(more(found));
    }
    choose5();
  };
  var nothing2 = (found) => found.unlike ? `No ${found.level === "clip" ? "clip" : "other moment"} is like this query: the chance that any shows the same action is below 1 %.` : found.inputs.label || found.inputs.named || found.inputs.lasting ? "Nothing passes these filters. Widen them, or look for moments instead of whole clips." : "Nothing else is there to compare with. Add recordings, or choose another query.";
  function more(found) {
    const made = element("button", "search-button search-more", `Show more (${found.total - found.hits.length} left)`);
    made.type = "button";
    made.addEventListener("click", () => changeView({ top: String(Math.min(found.hits.length + MORE, 300)) }));
    return made;
  }
  function choose5() {
    for (const one of allWithin(document, ".search-hit")) {
      const chosen3 = one.dataset.hit === now5.view.hit;
      if (chosen3 !== one.classList.contains("chosen")) {
        one.classList.toggle("chosen", chosen3);
        const names2 = within(one, ".search-why-names");
        names2.replaceChildren(...chosen3 ? now5.body.leaves.map((leaf) => {
          const name = element("span", "", now5.body.words[leaf]);
          name.dataset.part = leaf;
          return name;
        }) : []);
        const { strip } = (
          /** @type {HitRow} */
          one
        );
        if (strip) paintStrip(canvasOf(one), strip);
      }
      within(one, ".search-open").setAttribute("aria-pressed", String(chosen3));
    }
  }
  var playing2 = "";
  var playHits = async () => {
    const { found, view: view4 } = now5;
    if (!found || !found.request || view4.look && view4.look !== "search") return;
    const wanted2 = JSON.stringify([found.request, view4.hit || "", view4.parts || ""]);
    if (wanted2 === playing2 && player.status !== "empty") return;
    const first = playing2 === "";
    playing2 = wanted2;
    if (!view4.hit) return put3(found.request, first);
    try {
      const { request: request5 } = reasonNow(view4.hit) || await reasonOf(view4.hit);
      if (playing2 === wanted2) put3(request5, first);
    } catch (error) {
      notify("This hit cannot be shown", error instanceof Error ? error.message : "");
      changeView({ hit: "" });
    }
  };
  function put3(request5, first) {
    const stage2 = player;
    const paired = (stage2.layout === "side" || stage2.layout === "overlay") && !first && last2 > 1;
    const layout = request5.items.length > 1 && paired ? stage2.layout : request5.layout;
    last2 = request5.items.length;
    if (Object.keys(now5.selection).length) setStore(SELECTION, {});
    setStore(STAGE_REQUEST, { ...request5, layout });
  }
  var last2 = 0;
  var seekPiece = (index, frame) => {
    const piece = now5.found.pieces[index];
    const inside2 = player.seek({ clip: piece.clip, frame, dataset: piece.source });
    if (!inside2) setStore(STAGE_REQUEST, { ...now5.found.request, at: void 0 });
  };
  window.addEventListener("stage-frame", (event) => {
    if (!find(SEARCH_HITS) || !now5.found || !now5.found.pieces) return;
    const { items, time, duration } = event.detail;
    const share2 = duration ? time / duration : 0;
    allWithin(document, ".search-hit .search-why-cursor").forEach((line3) => {
      const on2 = around(line3, ".search-hit").classList.contains("chosen") && items.length > 1;
      line3.style.display = on2 ? "block" : "none";
      if (on2) line3.style.setProperty("--at", String(share2));
    });
    now5.found.pieces.forEach((piece, k) => {
      const node = allWithin(document, `.search-source[data-index="${k}"] .search-cursor`)[0];
      const item = items.find((one) => one.clip === piece.clip && one.index === (now5.found.pieces.length > 1 ? k : 0));
      if (!node) return;
      const shade = within(around(node, ".search-track"), ".search-selection");
      node.style.display = item ? "block" : "none";
      if (!item) return;
      const inside2 = (item.frame - piece.start) / Math.max(piece.end - piece.start, 1);
      node.style.left = `calc(${shade.style.left} + (${shade.style.width}) * ${inside2.toFixed(4)})`;
    });
  });
  document.addEventListener("click", (event) => {
    const open6 = closest(event, ".search-open");
    if (open6) {
      const { hit: hit2 = "" } = around(open6, ".search-hit").dataset;
      changeView({ hit: hit2 === now5.view.hit ? "" : hit2 });
    }
    const why = closest(event, ".search-why");
    if (!why) return;
    const hit = around(why, ".search-hit");
    const box4 = why.getBoundingClientRect();
    const share2 = (event.clientX - box4.left) / box4.width;
    if (!hit.classList.contains("chosen")) changeView({ hit: hit.dataset.hit ?? "" });
    else player.seek(share2 * player.duration);
  });
  document.addEventListener("pointermove", (event) => {
    if (hasClass(event, "search-why")) describe2(event);
  });
  var resting = 0;
  document.addEventListener("pointerover", (event) => {
    clearTimeout(resting);
    const hit = closest(event, ".search-hit");
    if (hit) resting = setTimeout(() => reasonOf(hit.dataset.hit ?? "").then(({ request: request5 }) => player.prefetch(request5)).catch(() => {
    }), 90);
  });
  document.addEventListener("keydown", (event) => {
    const open6 = hasClass(event, "search-open");
    if (!open6 || event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
    const hit = around(targetOf(event), ".search-hit");
    const next2 = (
      /** @type {HTMLElement | null} */
      event.key === "ArrowDown" ? hit.nextElementSibling : hit.previousElementSibling
    );
    event.preventDefault();
    event.stopPropagation();
    if (next2) (allWithin(next2, ".search-open")[0] ?? next2).focus();
  });

  // search/options.mjs
  var waiting3 = 0;
  var option = (value, words4) => Object.assign(element("option", "", words4), { value });
  function labelled(words4, of2, ...controls) {
    const label = element("label", "search-label", words4);
    label.htmlFor = of2;
    return element("div", "search-option", label, ...controls);
  }
  function input(id, attributes) {
    return Object.assign(element("input", "search-text"), { id, autocomplete: "off", ...attributes });
  }
  function build2(box4) {
    const engine = element("select", "search-select", ...now5.engines.map(({ value, label: label2 }) => option(value, label2)));
    engine.id = SEARCH_ENGINE;
    const level = element("select", "search-select", option("clip", "Whole clips"), option("interval", "Moments of clips"));
    level.id = SEARCH_LEVEL;
    const route = Object.assign(element("input", "search-route"), { id: SEARCH_ROUTE, type: "range", min: 0, max: 100, step: 5 });
    const says = element("span", "search-route-says number");
    const label = element("select", "search-select");
    label.id = SEARCH_LABEL;
    const shortest = input(SEARCH_SHORTEST, { type: "number", min: 0, step: 0.1, placeholder: "from" });
    const longest2 = input(SEARCH_LONGEST, { type: "number", min: 0, step: 0.1, placeholder: "any" });
    longest2.setAttribute("aria-label", "At most this many seconds");
    const path2 = labelled("Path counts", SEARCH_ROUTE, route, says);
    path2.title = "How much the way over the ground counts: turning left or right, forwards or backwards";
    box4.replaceChildren(
      labelled("Engine", SEARCH_ENGINE, engine),
      labelled("Hits are", SEARCH_LEVEL, level),
      path2,
      labelled("Label", SEARCH_LABEL, label),
      labelled("Name has", SEARCH_NAMED, input(SEARCH_NAMED, { type: "search", placeholder: "any clip" })),
      labelled("Seconds", SEARCH_SHORTEST, shortest, element("span", "muted", "to"), longest2)
    );
  }
  var drawOptions = () => {
    const box4 = find(SEARCH_OPTIONS);
    if (!box4) return;
    if (!box4.firstChild) build2(box4);
    const { view: view4, found, clips } = now5;
    const actions4 = clips && clips.actions || [];
    const label = need(SEARCH_LABEL);
    const mark3 = JSON.stringify(actions4);
    if (label.dataset.mark !== mark3) {
      label.dataset.mark = mark3;
      label.replaceChildren(option("", "any"), ...actions4.map((action) => option(action, action)));
    }
    around(label, ".search-option").classList.toggle("hidden", !actions4.length);
    const [shortest, longest2] = (view4.lasting || "-").split("-");
    const values = {
      [SEARCH_ENGINE]: view4["search-method"] || "bounded-edit",
      [SEARCH_LEVEL]: view4.level || found && found.level || "clip",
      [SEARCH_ROUTE]: view4.route || "0",
      [SEARCH_LABEL]: view4.label || "",
      [SEARCH_NAMED]: view4.named || "",
      [SEARCH_SHORTEST]: shortest,
      [SEARCH_LONGEST]: longest2
    };
    if (!waiting3) {
      for (const [id, value] of Object.entries(values)) if (find(id) !== document.activeElement || need(id).tagName === "SELECT") need(id).value = value;
    }
    sayRoute();
    fold();
  };
  var folded = null;
  function fold() {
    const [button5, box4] = [need(SEARCH_COUNTS), need(SEARCH_WANTED)];
    const little = button5.clientWidth < 780;
    const closed = folded ?? (little && Boolean(now5.view.query));
    button5.setAttribute("aria-expanded", String(!closed));
    box4.classList.toggle("hidden", closed);
    const chosen3 = (id) => (
      /** @type {any} */
      need(id).selectedOptions[0]?.textContent
    );
    const { view: view4 } = now5;
    const summary2 = [
      find(SEARCH_PRESET) && chosen3(SEARCH_PRESET),
      chosen3(SEARCH_ENGINE),
      chosen3(SEARCH_LEVEL),
      view4.route && `path ${view4.route} %`,
      view4.label,
      view4.named && `“${view4.named}”`,
      view4.lasting && `${view4.lasting} s`
    ];
    need(SEARCH_COUNTS_SAYS).textContent = summary2.filter(Boolean).join(" · ");
  }
  document.addEventListener("click", (event) => {
    const button5 = closest(event, `#${SEARCH_COUNTS}`);
    if (!button5) return;
    folded = button5.getAttribute("aria-expanded") === "true";
    fold();
  });
  function sayRoute() {
    const { value, style } = need(SEARCH_ROUTE);
    style.setProperty("--share", `${value}%`);
    within(document, ".search-route-says").textContent = `${value} %`;
  }
  function lasting() {
    const [low, high] = [SEARCH_SHORTEST, SEARCH_LONGEST].map((id) => need(id).value.trim());
    return low || high ? `${low}-${high}` : "";
  }
  function take3(id) {
    const value = find(id) ? need(id).value : "";
    if (id === SEARCH_ENGINE) changeSearch({ "search-method": value === "bounded-edit" ? "" : value });
    else if (id === SEARCH_LEVEL) changeSearch({ level: value, top: "" });
    else if (id === SEARCH_ROUTE) changeSearch({ route: value === "0" ? "" : value });
    else if (id === SEARCH_LABEL) changeSearch({ label: value, top: "" });
    else if (id === SEARCH_NAMED) changeSearch({ named: value.trim(), top: "" });
    else changeSearch({ lasting: lasting(), top: "" });
  }
  var mine = (target2) => target2.closest && target2.closest(`#${SEARCH_OPTIONS}`);
  document.addEventListener("change", (event) => {
    if (mine(targetOf(event)) && targetOf(event).tagName === "SELECT") take3(targetOf(event).id);
  });
  document.addEventListener("input", (event) => {
    if (!mine(targetOf(event)) || targetOf(event).tagName === "SELECT") return;
    if (targetOf(event).id === SEARCH_ROUTE) sayRoute();
    clearTimeout(waiting3);
    const { id } = targetOf(event);
    waiting3 = setTimeout(() => {
      waiting3 = 0;
      take3(id);
    }, 220);
  });

  // search/pieces.mjs
  var PICTURES = 12;
  var LABELS2 = ["#4e79a7", "#f28e2b", "#59a14f", "#e15759", "#b07aa1", "#9c755f", "#76b7b2", "#d4a720", "#ff9da7", "#79706e"];
  var shownWindows = /* @__PURE__ */ new Map();
  var pieceName = (piece) => `${piece.dataset} ${piece.clip}`;
  var shownOf = (piece) => shownWindows.get(pieceName(piece)) || [0, piece.frames];
  function pictures(piece, [from, to]) {
    const box4 = element("div", "search-pictures");
    const step3 = (to - from) / PICTURES;
    for (let k = 0; k < PICTURES; k++) {
      const start3 = Math.round(from + k * step3);
      const end = Math.max(Math.round(from + (k + 1) * step3), start3 + 1);
      const picture2 = element("img");
      const pairs = new URLSearchParams({ start: String(start3), end: String(Math.min(end, piece.frames)), n: "1", v: piece.version.slice(0, 8) });
      picture2.src = `/api/filmstrip/${encodeURIComponent(piece.source)}/${encodeURIComponent(piece.clip)}?${pairs}`;
      picture2.alt = "";
      picture2.draggable = false;
      box4.append(picture2);
    }
    return box4;
  }
  function labels(piece, [from, to]) {
    const box4 = element("div", "search-labels");
    const actions4 = now5.clips ? now5.clips.actions : [];
    for (const [start3, end, action] of piece.labels) {
      if (end <= from || start3 >= to) continue;
      const block2 = element("span", "search-label-block", action);
      block2.title = `${action}, ${clock(start3 / piece.fps)} to ${clock(end / piece.fps)}. Click to look for it.`;
      block2.dataset.range = `${start3}-${end}`;
      block2.style.setProperty("--tone", LABELS2[Math.max(actions4.indexOf(action), 0) % LABELS2.length]);
      place4(block2, Math.max(start3, from), Math.min(end, to), [from, to]);
      box4.append(block2);
    }
    return box4;
  }
  var place4 = (node, start3, end, [from, to]) => {
    node.style.left = 100 * (start3 - from) / (to - from) + "%";
    node.style.width = Math.max(100 * (end - start3) / (to - from), 0.3) + "%";
  };
  function handle(which, piece) {
    const made = element("div", "search-handle search-handle-" + which);
    made.tabIndex = 0;
    made.setAttribute("role", "slider");
    made.setAttribute("aria-label", which === "start" ? "First frame of the query" : "End of the query");
    made.setAttribute("aria-valuemin", String(0));
    made.setAttribute("aria-valuemax", String(piece.frames));
    made.dataset.end = which;
    return made;
  }
  function tool(symbol, label, action) {
    const made = element("button", "search-tool", icon(symbol, 14));
    made.type = "button";
    made.title = label;
    made.setAttribute("aria-label", label);
    made.dataset.piece = action;
    return made;
  }
  function sourceRow(piece, index, several) {
    const made = element("div", "search-source");
    made.dataset.index = String(index);
    made.style.setProperty("--own", piece.colour);
    const badge = element("button", "search-badge", "ABCDEF"[index]);
    badge.type = "button";
    badge.dataset.piece = "active";
    badge.title = `Parts one clicks in the figure come from ${"ABCDEF"[index]}`;
    const name = element("input", "search-clip");
    name.setAttribute("list", SEARCH_CLIP_NAMES);
    name.setAttribute("aria-label", "Clip that is looked for");
    name.placeholder = "Choose a clip";
    name.value = piece.dataset ? piece.clip : piece.clip;
    name.title = piece.dataset.startsWith("~upload~") ? "An uploaded recording" : piece.dataset ? `From ${piece.source}` : piece.clip;
    const gives = element("span", "search-gives muted", several ? piece.gives : piece.dataset.startsWith("~upload~") ? "uploaded" : "");
    const head3 = element(
      "div",
      "search-source-head",
      several ? badge : null,
      name,
      gives,
      element("span", "search-span number"),
      element("span", "spacer"),
      tool("minus", "Show more of the clip", "out"),
      tool("plus", "Zoom in on the range", "in"),
      tool("fit", "Take the whole clip", "whole"),
      several ? tool("close", "Leave this piece out", "remove") : null
    );
    const track = element("div", "search-track");
    const range2 = shownOf(piece);
    const box4 = element("div", "search-selection", handle("start", piece), handle("end", piece));
    track.append(
      pictures(piece, range2),
      labels(piece, range2),
      element("div", "search-shade search-shade-left"),
      element("div", "search-shade search-shade-right"),
      box4,
      element("div", "search-cursor")
    );
    made.append(head3, track);
    return made;
  }
  function placeRange(node, piece) {
    const range2 = shownOf(piece);
    const { start: start3, end, fps, frames } = piece;
    place4(within(node, ".search-selection"), Math.max(start3, range2[0]), Math.min(end, range2[1]), range2);
    place4(within(node, ".search-shade-left"), range2[0], Math.max(start3, range2[0]), range2);
    place4(within(node, ".search-shade-right"), Math.min(end, range2[1]), range2[1], range2);
    within(node, ".search-shade-left").style.minWidth = "0";
    for (
      const [which, value] of
      /** @type {[string, number][]} */
      [["start", start3], ["end", end]]
    ) {
      const one = within(node, ".search-handle-" + which);
      one.setAttribute("aria-valuenow", String(value));
      one.setAttribute("aria-valuetext", clock(value / fps));
    }
    const whole3 = start3 === 0 && end === frames;
    within(node, ".search-span").textContent = whole3 ? `whole clip, ${(frames / fps).toFixed(1)} s` : `${clock(start3 / fps)} to ${clock(end / fps)}, ${((end - start3) / fps).toFixed(1)} s`;
  }
  function emptyRow() {
    const name = element("input", "search-clip");
    name.setAttribute("list", SEARCH_CLIP_NAMES);
    name.setAttribute("aria-label", "Clip that is looked for");
    name.placeholder = now5.clips ? "Choose a clip" : "No dataset yet";
    const hint = element("span", "muted search-hint", "What motion do you look for? Choose a clip, then drag over the part that matters.");
    const made = element("div", "search-source search-source-empty", element("div", "search-source-head", name, hint));
    made.dataset.index = String(0);
    return made;
  }

  // search/upload.mjs
  var HEADERS2 = { "X-Motionscape": "upload" };
  var status = () => find(SEARCH_UPLOAD_STATUS);
  var sending = null;
  var turn4 = 0;
  var suffixes = () => (within(document, ".search-choose").dataset.suffixes ?? "").split(",").filter((one) => one !== ".csv");
  function say2(words4, kind = "muted") {
    const box4 = document.querySelector(".search-sending") || element("span", "search-sending");
    box4.className = `search-sending ${kind}`;
    box4.textContent = words4;
    if (!box4.isConnected) status()?.before(box4);
  }
  var quiet = () => allWithin(document, ".search-sending").forEach((one) => one.remove());
  function put4(token, file, tell5) {
    return (
      /** @type {Promise<void>} */
      new Promise((resolve, reject) => {
        const request5 = new XMLHttpRequest();
        sending = request5;
        request5.open("PUT", `/api/uploads/${token}/${encodeURIComponent(file.name)}`);
        request5.setRequestHeader("X-Motionscape", "upload");
        request5.setRequestHeader("Content-Type", "application/octet-stream");
        request5.upload.onprogress = (event) => tell5(event.loaded / Math.max(event.total, 1));
        request5.onloadend = () => {
          if (request5.status === 200) return resolve();
          let message2 = request5.status ? "The server refused the file." : "The connection broke; try again.";
          try {
            message2 = JSON.parse(request5.responseText).error || message2;
          } catch {
          }
          return reject(new Error(message2));
        };
        request5.send(file);
      })
    );
  }
  async function send3(files) {
    if (!files.length) return;
    const mine2 = ++turn4;
    if (sending) sending.abort();
    setStore(SEARCH_UPLOAD, null);
    const wrong = files.find((file) => !suffixes().some((suffix) => file.name.toLowerCase().endsWith(suffix)));
    if (wrong) return say2(`${wrong.name} is not a kind of file we read: choose BVH, or AMC together with its ASF.`, "error-text");
    let token = null;
    const still = () => {
      if (mine2 !== turn4) throw new Error("Other files were chosen meanwhile.");
    };
    try {
      const answer2 = await fetch("/api/uploads", { method: "POST", headers: HEADERS2 }).catch(() => null);
      if (!answer2?.ok) throw new Error("The server cannot take files now; try again in a moment.");
      ({ token } = await answer2.json());
      for (const file of files) {
        still();
        await put4(token, file, (share2) => mine2 === turn4 && say2(`Sending ${file.name}: ${Math.round(100 * share2)} %`));
      }
      still();
      sending = null;
      quiet();
      const main = files.find((file) => !/\.asf(\.gz)?$/i.test(file.name)) || files[0];
      setStore(SEARCH_UPLOAD, { token, name: main.name });
    } catch (error) {
      if (token) fetch(`/api/uploads/${token}`, { method: "DELETE", headers: HEADERS2 }).catch(() => {
      });
      if (mine2 !== turn4) return;
      sending = null;
      say2(error instanceof Error ? error.message : String(error), "error-text");
    }
  }
  var chooseRecording = () => {
    const chooser = document.createElement("input");
    chooser.type = "file";
    chooser.multiple = true;
    chooser.accept = suffixes().join(",");
    chooser.onchange = () => send3([...chooser.files ?? []]);
    chooser.click();
  };
  document.addEventListener("drop", (event) => {
    const files = event.dataTransfer && [...event.dataTransfer.files];
    if (!files || !files.length || !document.querySelector(".search-query")) return;
    event.preventDefault();
    send3(files);
  });

  // search/sources.mjs
  var clipCalled = (name) => now5.clips && now5.clips.clips.find((clip) => clip[0] === name);
  var drawn7 = "";
  var dragged2 = null;
  var drawSources = () => {
    const box4 = need(SEARCH_SOURCES);
    const pieces = now5.found && now5.found.pieces || [];
    const mark3 = JSON.stringify([now5.clips && [now5.clips.dataset, now5.clips.version, Boolean(now5.clips.clips.length)], pieces.map((p) => [p.dataset, p.clip, p.version, p.gives, p.labels.length, shownOf(p)])]);
    if (mark3 !== drawn7 || !box4.firstChild) {
      const focus2 = document.activeElement && box4.contains(document.activeElement) ? [closest({ target: document.activeElement }, ".search-source")?.dataset.index, document.activeElement.className] : null;
      drawn7 = mark3;
      now5.active = Math.min(now5.active, Math.max(pieces.length - 1, 0));
      box4.replaceChildren(...pieces.length ? pieces.map((piece, k) => sourceRow(piece, k, pieces.length > 1)) : [emptyRow()]);
      const again = focus2 && focus2[1] && allWithin(box4, `[data-index="${focus2[0]}"] *`).find((one) => one.className === focus2[1]);
      if (again) again.focus();
      names();
    }
    pieces.forEach((piece, k) => {
      if (!dragged2 || dragged2.index !== k) placeRange(childrenOf(box4)[k], piece);
    });
    allWithin(box4, ".search-source").forEach((one, k) => one.classList.toggle("active", k === now5.active && pieces.length > 1));
    drawMotifs2();
    const back = document.querySelector("[data-search='back']");
    if (back) back.classList.toggle("hidden", !canGoBack());
    const combineButton = allWithin(document, "[data-search='combine']")[0];
    if (combineButton) combineButton.disabled = !pieces.length || pieces.length >= 6;
    const warning = need(SEARCH_WARNING);
    const doubt = now5.found && now5.found.doubt || "";
    warning.classList.toggle("hidden", !doubt);
    warning.textContent = doubt;
  };
  var named2 = null;
  function names() {
    const list3 = find(SEARCH_CLIP_NAMES);
    if (!list3 || named2 === now5.clips && list3.firstChild) return;
    named2 = now5.clips;
    list3.replaceChildren(...(now5.clips ? now5.clips.clips : []).slice(0, 5e3).map(([name]) => {
      const option2 = element("option");
      option2.value = name;
      return option2;
    }));
  }
  function drawMotifs2() {
    const select3 = find(SEARCH_MOTIF);
    const mark3 = JSON.stringify(now5.motifs);
    if (!select3 || select3.dataset.mark === mark3) return;
    select3.dataset.mark = mark3;
    const first = element("option", "", "From a motif …");
    first.value = "";
    select3.replaceChildren(first, ...now5.motifs.map(({ name, motions: motions2, query: query2 }) => {
      const option2 = element("option", "", `${name} (${motions2} motions)`);
      option2.value = query2;
      return option2;
    }));
    select3.classList.toggle("hidden", !now5.motifs.length);
  }
  function takeClip(index, name) {
    const clip = clipCalled(name);
    if (!clip) return false;
    const pieces = copyPieces();
    const leaves = pieces[index] ? pieces[index].leaves : [...now5.body.leaves];
    pieces[index] = { clip: name, dataset: "", start: 0, end: clip[1], leaves };
    searchFor(pieces);
    return true;
  }
  function setRange(index, start3, end) {
    const pieces = copyPieces();
    const piece = pieces[index];
    if (!piece) return;
    piece.start = Math.max(0, Math.min(start3, piece.frames - 1));
    piece.end = Math.max(piece.start + 1, Math.min(end, piece.frames));
    now5.found.pieces[index] = { ...now5.found.pieces[index], start: piece.start, end: piece.end };
    drawSources();
    searchFor(pieces);
  }
  function zoom3(index, action) {
    const piece = now5.found.pieces[index];
    const [from, to] = shownOf(piece);
    const wanted2 = action === "in" ? Math.max((piece.end - piece.start) * 1.6, (to - from) / 3, 16) : (to - from) * 2;
    const middle = (piece.start + piece.end) / 2;
    const width = Math.min(wanted2, piece.frames);
    const start3 = Math.round(Math.min(Math.max(middle - width / 2, 0), piece.frames - width));
    if (width >= piece.frames) shownWindows.delete(pieceName(piece));
    else shownWindows.set(pieceName(piece), [start3, Math.round(start3 + width)]);
    drawSources();
  }
  function combine() {
    const pieces = copyPieces();
    const most = pieces.reduce((a, b) => b.leaves.length > a.leaves.length ? b : a);
    const limbs = ["lower_body", "left_arm_hand", "right_arm_hand", "left_leg_foot", "right_leg_foot", "head_torso", ...now5.body.leaves];
    const node = limbs.find((one) => now5.body.nodes[one].every((leaf) => most.leaves.includes(leaf)) && now5.body.nodes[one].length < most.leaves.length);
    if (!node) return;
    const given2 = now5.body.nodes[node];
    most.leaves = most.leaves.filter((leaf) => !given2.includes(leaf));
    pieces.push({ ...most, leaves: [...given2] });
    now5.active = pieces.length - 1;
    searchFor(pieces);
  }
  function fromStage() {
    const item = player.frameOf(0);
    if (!item) return notify("Nothing is on the Stage", "Play a clip, a motif or a walk first; what the Stage shows can then be looked for.");
    const here3 = !item.dataset || item.dataset === now5.clips.dataset;
    const piece = { clip: item.clip, start: item.start, end: item.end, dataset: here3 ? "" : item.dataset ?? "", leaves: [...now5.body.leaves] };
    return searchFor([piece]);
  }
  document.addEventListener("change", (event) => {
    if (targetOf(event).id === SEARCH_MOTIF && targetOf(event).value) {
      remember4();
      changeSearch({ query: targetOf(event).value });
      targetOf(event).value = "";
    } else if (hasClass(event, "search-clip")) {
      const index = Number(around(targetOf(event), ".search-source").dataset.index);
      const piece = now5.found && now5.found.pieces && now5.found.pieces[index];
      if (!takeClip(index, targetOf(event).value) && targetOf(event).value) {
        notify("No clip of this name", `“${targetOf(event).value}” is not in this dataset.`);
        targetOf(event).value = piece ? piece.clip : "";
      }
    }
  });
  document.addEventListener("input", (event) => {
    if (hasClass(event, "search-clip")) setStore(SEARCH_TYPED, targetOf(event).value);
    if (hasClass(event, "search-clip") && /** @type {InputEvent} */
    event.inputType === void 0 && clipCalled(targetOf(event).value)) {
      takeClip(Number(around(targetOf(event), ".search-source").dataset.index), targetOf(event).value);
    }
  });
  document.addEventListener("click", (event) => {
    const button5 = closest(event, "[data-search]");
    if (button5) {
      const acts = { stage: fromStage, combine, back: goBack, upload: chooseRecording };
      acts[button5.dataset.search ?? ""]?.();
      return;
    }
    const on2 = closest(event, "[data-piece]");
    if (!on2) return;
    const index = Number(around(on2, ".search-source").dataset.index);
    const piece = now5.found.pieces[index];
    if (on2.dataset.piece === "active") {
      now5.active = index;
      drawSources();
      drawBody();
    } else if (on2.dataset.piece === "whole") {
      shownWindows.delete(pieceName(piece));
      setRange(index, 0, piece.frames);
    } else if (on2.dataset.piece === "remove") {
      const pieces = copyPieces();
      const [gone] = pieces.splice(index, 1);
      pieces[0].leaves = now5.body.leaves.filter((leaf) => pieces[0].leaves.includes(leaf) || gone.leaves.includes(leaf));
      now5.active = 0;
      searchFor(pieces);
    } else zoom3(index, on2.dataset.piece ?? "");
  });
  var frameAt2 = (track, piece, x) => {
    const box4 = track.getBoundingClientRect();
    const [from, to] = shownOf(piece);
    return Math.round(from + Math.min(Math.max((x - box4.left) / box4.width, 0), 1) * (to - from));
  };
  document.addEventListener("pointerdown", (event) => {
    const track = closest(event, ".search-track");
    if (!track || event.button) return;
    const index = Number(around(track, ".search-source").dataset.index);
    const piece = now5.found.pieces[index];
    const at3 = frameAt2(track, piece, event.clientX);
    const end = targetOf(event).dataset.end;
    dragged2 = { index, track, at: at3, piece: { ...piece }, mode: end || "new", moved: false, start: 0, end: 0, id: event.pointerId, label: targetOf(event).dataset.range };
    track.setPointerCapture(event.pointerId);
    event.preventDefault();
    if (end) targetOf(event).focus();
  });
  document.addEventListener("pointermove", (event) => {
    if (!dragged2 || event.pointerId !== dragged2.id) return;
    const { piece, track, mode: mode3 } = dragged2;
    const frame = frameAt2(track, piece, event.clientX);
    if (Math.abs(frame - dragged2.at) > 0) dragged2.moved = true;
    if (!dragged2.moved) return;
    let [start3, end] = [piece.start, piece.end];
    if (mode3 === "start") start3 = Math.min(frame, end - 1);
    else if (mode3 === "end") end = Math.max(frame, start3 + 1);
    else [start3, end] = [Math.min(frame, dragged2.at), Math.max(frame, dragged2.at)];
    dragged2.start = start3;
    dragged2.end = Math.max(end, start3 + 1);
    placeRange(around(track, ".search-source"), { ...piece, start: start3, end: dragged2.end });
  });
  var release = (event) => {
    if (!dragged2 || event.pointerId !== dragged2.id) return;
    const { index, moved: moved2, start: start3, end, label, piece, track } = dragged2;
    const least = Math.max(2, Math.round(0.1 * piece.fps));
    dragged2 = null;
    if (event.type === "pointercancel") return drawSources();
    if (label && !moved2) return setRange(index, Number(label.split("-")[0]), Number(label.split("-")[1]));
    if (!moved2) return seekPiece(index, frameAt2(track, piece, event.clientX));
    if (end - start3 < least) return drawSources();
    return setRange(index, start3, end);
  };
  document.addEventListener("pointerup", release);
  document.addEventListener("pointercancel", release);
  document.addEventListener("keydown", (event) => {
    if (!hasClass(event, "search-handle")) return;
    const index = Number(around(targetOf(event), ".search-source").dataset.index);
    const piece = now5.found.pieces[index];
    const step3 = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageUp: 10, PageDown: -10 }[event.key];
    const by = event.shiftKey ? 10 * (step3 || 0) : step3;
    const home = event.key === "Home" ? -piece.frames : event.key === "End" ? piece.frames : by;
    if (!home) return;
    event.preventDefault();
    event.stopPropagation();
    if (targetOf(event).dataset.end === "start") setRange(index, Math.min(piece.start + home, piece.end - 1), piece.end);
    else setRange(index, piece.start, Math.max(piece.end + home, piece.start + 1));
  });

  // search/search.mjs
  register("search", {
    /**
     * @param {Found | null} found
     * @param {View | null} view
     * @param {ClipList | null} clips
     * @param {MotifQuery[] | null} motifs
     * @param {string} scheme
     * @param {Record<string, Weights>} presets
     * @param {Body | null} body
     * @param {any[]} engines
     * @param {any} key
     * @param {Selection | null} selection
     */
    draw(found, view4, clips, motifs2, scheme, presets, body2, engines, key, selection) {
      if (!find(SEARCH_SOURCES) || !body2) return clientside.no_update;
      Object.assign(now5, { found, view: view4 || {}, clips, motifs: motifs2 || [], scheme, presets, body: body2, engines, key, selection: selection || {} });
      const page2 = within(document, ".search-page");
      page2.dataset.look = now5.view.look || "search";
      page2.classList.toggle("without-dataset", !clips);
      const fits2 = found && clips && found.inputs && found.inputs.dataset === clips.dataset;
      if (!fits2) now5.found = /** @type {any} */
      null;
      drawSources();
      drawBody();
      drawOptions();
      drawHits3();
      playHits();
      return clientside.no_update;
    }
  });
  document.addEventListener("click", (event) => {
    const button5 = closest(event, "[data-similar]");
    if (!button5 || button5.disabled) return;
    const { clip, start: start3, end, dataset: dataset2 } = JSON.parse(button5.dataset.similar ?? "{}");
    const query2 = [escapeName(clip), `${start3}-${end}`, ...dataset2 ? [escapeName(dataset2)] : []].join(":");
    remember4();
    changeSearch({ query: query2, look: "" });
    if (!location.pathname.endsWith("/search")) clientside.set_props(URL2, { pathname: "/search", search: "" });
    else within(document, ".page").scrollTo({ top: 0, behavior: "smooth" });
  });

  // main.mjs
  window.motionscape = {
    stage: player,
    drawings,
    clip: { at, plot: chartPlot },
    map: { state, setKeys, edited: editedPosture },
    search: { now: now5 }
  };
})();
