using RayTracer.Desktop.ViewModels;
using RayTracer.Session;

namespace RayTracer.Desktop.Tests;

/// <summary>Every command of the session does here what it says.</summary>
public sealed class CommandTests
{
    [Fact]
    public void There_is_a_menu_item_for_every_command_and_keys_lead_to_the_same() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        CommandTable commands = test.Main.Commands;
        Assert.Equal(SessionCommand.All.Select(c => c.Id).Order(StringComparer.Ordinal), commands.Menus.SelectMany(m => m.Commands).Select(c => c.Id).Order(StringComparer.Ordinal));
        Assert.Equal("save", commands.OfKeys("s", HeldKeys.Mod)?.Id);
        Assert.Equal("saveAs", commands.OfKeys("s", HeldKeys.Mod | HeldKeys.Shift)?.Id);
        Assert.Equal("shortcuts", commands.OfKeys("?", HeldKeys.Shift)?.Id);
        Assert.Equal("Ctrl+Shift+Z", commands["redo"].KeysText.Replace("⌘", "Ctrl", StringComparison.Ordinal));
        Assert.Null(commands.OfKeys("x", HeldKeys.Mod));
    });

    [Fact]
    public void Every_command_does_what_it_says() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        Dictionary<string, Func<Task>> checks = new([.. FileChecks(test), .. EditChecks(test), .. ViewChecks(test), .. PaneChecks(test)], StringComparer.Ordinal);
        Assert.Equal(SessionCommand.All.Select(c => c.Id).Order(StringComparer.Ordinal), checks.Keys.Order(StringComparer.Ordinal));
        foreach ((string id, Func<Task> check) in checks)
        {
            Assert.True(test.Main.Commands[id].CanExecute(null), id);
            test.Do(id);
            await check();
            Assert.True(test.Main.Messages.All.All(m => !m.IsError), $"{id}: {string.Join("; ", test.Main.Messages.All.Select(m => m.Text))}");
        }
    });

    // In an order in which each leaves what the next one needs.
    private static Dictionary<string, Func<Task>> EditChecks(TestWindow test)
    {
        (MainViewModel main, SceneDocument document) = (test.Main, test.Session.Document);
        return new()
        {
            ["duplicate"] = () => test.Until(() => main.Properties.Thing is { Pointer: not "/shapes/0" } && document.IsDirty),
            ["rename"] = async () =>
            {
                RenameViewModel dialog = Assert.IsType<RenameViewModel>(main.Dialog);
                dialog.Name = "copy";
                dialog.Rename.Execute(null);
                await test.Until(() => main.Properties.Thing?.Title == "copy" && main.Outliner.Chosen?.Name == "copy");
            },
            ["delete"] = () => test.Until(() => main.Properties.Thing is null && !document.Text.Contains("copy", StringComparison.Ordinal)),
            ["undo"] = () => test.Until(() => document.Text.Contains("copy", StringComparison.Ordinal) && main.Commands["redo"].IsEnabled),
            ["redo"] = async () =>
            {
                await test.Until(() => !document.Text.Contains("copy", StringComparison.Ordinal));
                test.Session.Selection.Select("/shapes/1");
                await test.Until(() => main.Outliner.Chosen?.Pointer == "/shapes/1");
            },
            ["deselect"] = () => test.Until(() => test.Session.Selection.Pointer is null && main.Properties.Thing is null),
        };
    }

    private static Dictionary<string, Func<Task>> ViewChecks(TestWindow test)
    {
        (MainViewModel main, PictureView view) = (test.Main, test.Session.View);
        Dictionary<string, Func<Task>> checks = new()
        {
            ["restart"] = () => test.Until(() => view.Settings.Mode == RenderMode.Running),
            ["pause"] = () => test.Until(() => view.Settings.Mode is RenderMode.Paused or RenderMode.Running),
            ["stop"] = () => test.Until(() => view.Settings.Mode == RenderMode.Stopped),
            ["filter"] = () => test.Until(() => !view.Settings.FiltersMotion),
            ["home"] = () => test.Until(() => main.Dispatcher.Idle.IsCompleted),
            ["setCamera"] = () => test.Until(() => main.Dispatcher.Idle.IsCompleted),
            ["frame"] = () => test.Until(() => !test.Session.View.IsSceneCamera),
            ["fit"] = () => Holds(main.Viewport.Stage.Zoom is null),
            ["actualSize"] = () => Holds(Math.Abs(main.Viewport.Stage.Zoom!.Value - 1) < 1e-9),
            ["zoomIn"] = () => Holds(main.Viewport.Stage.Zoom > 1.4),
            ["zoomOut"] = () => Holds(Math.Abs(main.Viewport.Stage.Zoom!.Value - 1) < 1e-6),
            ["snapshot"] = () => test.Until(() => main.Viewport.IsWiping && main.Viewport.HasComparisons),
        };
        foreach (Tool tool in Enum.GetValues<Tool>())
        {
            checks[$"tool{tool}"] = () => Holds(main.Viewport.Tool == tool && main.Commands[$"tool{tool}"].IsOn);
        }

        return checks;
    }

    private static Dictionary<string, Func<Task>> PaneChecks(TestWindow test)
    {
        MainViewModel main = test.Main;
        return new()
        {
            ["showScene"] = () => Holds(!main.Layout.IsLeftOpen && !main.Commands["showScene"].IsOn),
            ["showPanel"] = () => Holds(!main.Layout.IsRightOpen),
            ["showDock"] = () => Holds(!main.Layout.IsDockOpen),
            ["source"] = () => Holds(main.Layout is { IsDockOpen: true, DockTab: 0 }),
            ["inside"] = () => Holds(main.Layout is { IsDockOpen: true, DockTab: 1 }),
            ["gallery"] = () => Holds(main.Layout is { IsLeftOpen: true, LeftTab: 1 }),
            ["theme"] = () => Holds(main.Layout.Theme == "light"),
            ["shortcuts"] = () => Closes<ShortcutsViewModel>(main),
            ["tour"] = () => Closes<TourViewModel>(main),
        };
    }

    private static Dictionary<string, Func<Task>> FileChecks(TestWindow test)
    {
        (MainViewModel main, SceneDocument document) = (test.Main, test.Session.Document);
        test.Services.Chosen = test["saved.json"];
        return new()
        {
            ["saveAs"] = () => test.Until(() => File.Exists(test["saved.json"]) && document.Place.Name == "saved.json"),
            ["save"] = () => test.Until(() => main.Dispatcher.Idle.IsCompleted && !document.IsDirty),
            ["copyCommand"] = () => test.Until(() => test.Services.Clipboard is string text && text.StartsWith("raytracer render", StringComparison.Ordinal)),
            ["copyImage"] = () => test.Until(() => test.Services.Clipboard is byte[] { Length: > 100 }),
            ["export"] = async () =>
            {
                ExportViewModel dialog = Assert.IsType<ExportViewModel>(main.Dialog);
                dialog.Format = dialog.Formats.First(f => f.Value == "exr");
                dialog.Layers[0].IsOn = true;
                test.Services.Chosen = test["picture.exr"];
                dialog.Write.Execute(null);
                await test.Until(() => main.Messages.All.Any(m => m.Text.Contains("picture.exr", StringComparison.Ordinal)) && File.Exists(test["picture.exr"]));
                test.Services.Chosen = test["bundle.zip"];
            },
            ["bundle"] = () => test.Until(() => main.Dispatcher.Idle.IsCompleted && File.Exists(test["bundle.zip"])),
            ["new"] = async () =>
            {
                await test.Until(() => document.Place.Name == "new scene.json");
                test.Services.Chosen = test["saved.json"];
            },
            ["open"] = async () =>
            {
                await test.Until(() => document.Place.Path == test["saved.json"] && main.DocumentName == "saved.json");
                test.Session.Selection.Select("/shapes/0");
                await test.Until(() => main.Properties.Thing?.Pointer == "/shapes/0" && main.Things.Selected is not null);
            },
        };
    }

    private static Task Closes<T>(MainViewModel main)
        where T : DialogViewModel
    {
        Assert.IsType<T>(main.Dialog).Cancel.Execute(null);
        Assert.Null(main.Dialog);
        return Task.CompletedTask;
    }

    private static Task Holds(bool isSo)
    {
        Assert.True(isSo);
        return Task.CompletedTask;
    }
}
