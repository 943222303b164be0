using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The action of each command in this window. The session has the list of commands.</summary>
internal sealed class CommandTable
{
    private const double Sqrt2 = 1.41421356;
    private readonly Dictionary<string, CommandViewModel> _commands;
    private readonly Layout _layout;
    private readonly ViewportViewModel _viewport;
    private bool _isRendering;

    /// <summary>The commands of a window.</summary>
    public CommandTable(MainViewModel main)
    {
        (_layout, _viewport) = (main.Layout, main.Viewport);
        Dictionary<string, Action> actions = new([.. FileActions(main), .. EditActions(main), .. ViewActions(main), .. ToolActions(main)], StringComparer.Ordinal);
        _commands = SessionCommand.All.ToDictionary(c => c.Id, c => new CommandViewModel(c, Marking(actions[c.Id])), StringComparer.Ordinal);
        Mark();
    }

    /// <summary>All commands in menus.</summary>
    public IReadOnlyList<CommandGroup> Menus => field ??=
        [.. SessionTexts.Keys("groups").Select(g => new CommandGroup(SessionTexts.Of($"groups.{g}"), [.. SessionCommand.All.Where(c => c.Group == g).Select(c => _commands[c.Id])]))];

    /// <summary>Those of the row at the top.</summary>
    public IReadOnlyList<CommandViewModel> Bar => field ??= Of("save", "undo", "redo", "pause", "stop", "restart", "export");

    /// <summary>Those that show panes.</summary>
    public IReadOnlyList<CommandViewModel> Panes => field ??= Of("showScene", "showDock", "showPanel", "theme");

    /// <summary>Those that choose what the pointer does.</summary>
    public IReadOnlyList<CommandViewModel> Tools =>
        field ??= Of("toolSelect", "toolMove", "toolRotate", "toolScale", "toolFocus", "toolInspect", "toolRegion");

    /// <summary>Those of the picture's size.</summary>
    public IReadOnlyList<CommandViewModel> ZoomBar => field ??= Of("fit", "actualSize", "zoomIn", "zoomOut", "snapshot");

    /// <summary>Those of the selected thing.</summary>
    public IReadOnlyList<CommandViewModel> ThingBar => field ??= Of("rename", "duplicate", "delete");

    /// <summary>A command by its id.</summary>
    public CommandViewModel this[string id] => _commands[id];

    /// <summary>The command of a press of keys; null where there is none.</summary>
    public CommandViewModel? OfKeys(string key, HeldKeys keys) =>
        SessionCommand.All.FirstOrDefault(c => c.IsPressed(key, keys.HasFlag(HeldKeys.Mod), keys.HasFlag(HeldKeys.Shift), keys.HasFlag(HeldKeys.Alt))) is { } found ? _commands[found.Id] : null;

    /// <summary>Marks the commands that can be done, and those that are on.</summary>
    public void Show(SessionState state)
    {
        _isRendering = state.Render.Status == "rendering";
        this["undo"].IsEnabled = state.Document.CanUndo;
        this["redo"].IsEnabled = state.Document.CanRedo;
        Mark();
    }

    private Action Marking(Action action) => () =>
    {
        action();
        Mark();
    };

    private void Mark()
    {
        this["showScene"].IsOn = _layout.IsLeftOpen;
        this["showPanel"].IsOn = _layout.IsRightOpen;
        this["showDock"].IsOn = _layout.IsDockOpen;
        foreach (Tool tool in Enum.GetValues<Tool>())
        {
            this[$"tool{tool}"].IsOn = _viewport.Tool == tool;
        }
    }

    private CommandViewModel[] Of(params string[] ids) => [.. ids.Select(id => _commands[id])];

    private static Dictionary<string, Action> FileActions(MainViewModel main) => new()
    {
        ["new"] = () => _ = main.Files.New(),
        ["open"] = () => _ = main.Files.Open(),
        ["gallery"] = () => main.Layout.OpenLeft("gallery"),
        ["save"] = () => _ = main.Files.Save(),
        ["saveAs"] = () => _ = main.Files.SaveAs(),
        ["export"] = () => main.Ask(new ExportViewModel((format, bits, layers) => _ = main.Files.Export(format, bits, layers))),
        ["copyImage"] = () => _ = main.Files.CopyPicture(),
        ["copyCommand"] = () => _ = main.Files.CopyCommand(),
        ["bundle"] = () => _ = main.Files.Bundle(),
    };

    private static Dictionary<string, Action> EditActions(MainViewModel main) => new()
    {
        ["undo"] = () => main.Dispatcher.Do(s => s.Document.Undo()),
        ["redo"] = () => main.Dispatcher.Do(s => s.Document.Redo()),
        ["duplicate"] = main.Things.Duplicate,
        ["delete"] = main.Things.Delete,
        ["rename"] = main.AskForName,
        ["deselect"] = () => main.Dispatcher.Do(s => s.Selection.Select(null)),
    };

    private Dictionary<string, Action> ViewActions(MainViewModel main) => new()
    {
        ["pause"] = () => Render(main, _isRendering ? RenderMode.Paused : RenderMode.Running),
        ["stop"] = () => Render(main, RenderMode.Stopped),
        ["restart"] = () => main.Dispatcher.Do(s => s.View.Change(v => v with { Mode = RenderMode.Running }, restart: true)),
        ["filter"] = () => main.Dispatcher.Do(s => s.View.Change(v => v with { FiltersMotion = !v.FiltersMotion })),
        ["home"] = main.Viewport.Camera.Home,
        ["setCamera"] = () => main.Dispatcher.Do(s => s.Camera.Write()),
        ["frame"] = () => main.Dispatcher.Do(s => s.Camera.Move(new(CameraMoveKind.Frame, Pointer: s.Selection.Pointer is { } p && SceneThings.IsSeen(p) ? p : null))),
        ["fit"] = main.Viewport.Fit,
        ["actualSize"] = main.Viewport.ActualSize,
        ["zoomIn"] = () => main.Viewport.ZoomBy(Sqrt2),
        ["zoomOut"] = () => main.Viewport.ZoomBy(1 / Sqrt2),
        ["snapshot"] = main.Viewport.Keep,
        ["showScene"] = () => main.Layout.IsLeftOpen ^= true,
        ["showPanel"] = () => main.Layout.IsRightOpen ^= true,
        ["showDock"] = () => main.Layout.IsDockOpen ^= true,
        ["source"] = () => main.Layout.OpenDock("source"),
        ["inside"] = () => main.Layout.OpenDock("paths"),
        ["theme"] = main.Layout.NextTheme,
        ["shortcuts"] = () => main.Ask(new ShortcutsViewModel()),
        ["tour"] = () => main.Ask(new TourViewModel()),
    };

    private static Dictionary<string, Action> ToolActions(MainViewModel main) =>
        Enum.GetValues<Tool>().ToDictionary(t => $"tool{t}", t => (Action)(() => main.Viewport.Tool = t));

    private static void Render(MainViewModel main, RenderMode mode) => main.Dispatcher.Do(s => s.View.Change(v => v with { Mode = mode }));
}

/// <summary>A menu: commands that belong together.</summary>
/// <param name="Name">The name.</param>
/// <param name="Commands">The commands.</param>
internal sealed record CommandGroup(string Name, IReadOnlyList<CommandViewModel> Commands);
