using Avalonia;
using Avalonia.Controls;
using Avalonia.VisualTree;
using RayTracer.Desktop.ViewModels;
using RayTracer.Desktop.Views;
using RayTracer.Session;

namespace RayTracer.Desktop.Tests;

/// <summary>Every view is laid out at three sizes, with a session behind it, and each of its bindings has a value.</summary>
public sealed class LayoutTests
{
    [Theory]
    [InlineData(640, 400)]
    [InlineData(1280, 800)]
    [InlineData(2560, 1440)]
    public void Every_view_is_laid_out_and_has_values(double width, double height) => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        HashSet<Type> seen = [];
        await foreach (string state in States(test))
        {
            test.Layout(width, height);
            foreach (Visual visual in test.Window.GetVisualDescendants().Where(v => v.IsEffectivelyVisible))
            {
                Assert.True(double.IsFinite(visual.Bounds.Width) && double.IsFinite(visual.Bounds.Height), $"{visual} in {state}");
                Assert.True(visual is not UserControl { DataContext: null }, $"{visual} in {state} shows nothing");
                seen.Add(visual.GetType());
            }

            Assert.True(test.View<MainView>().Bounds.Size == new Size(width, height), state);
        }

        Type[] views = [.. typeof(MainView).Assembly.GetTypes().Where(t => t.IsSubclassOf(typeof(UserControl)) && t != typeof(AddView))];
        Assert.Equal([], views.Except(seen).Select(v => v.Name));
        // A tab's content stands nowhere for a moment while it is changed for another one's.
        string[] complaints = [.. Ui.Log.Take().Where(c => !c.EndsWith("DataContext | Null value in expression '{empty}' at ''.", StringComparison.Ordinal))];
        Assert.True(complaints.Length == 0, string.Join('\n', complaints));

        // Showing it all has changed nothing.
        Assert.True(!test.Session.Document.IsDirty, $"{test.Session.Document.Status.UndoLabel}: {test.Session.Document.Text}");
        Assert.Equal(Tone.Plain, test.Session.View.Tone);
    });

    private static async IAsyncEnumerable<string> States(TestWindow test)
    {
        MainViewModel main = test.Main;
        main.Paths.Inspect(30, 20);
        test.Session.Selection.Select("/shapes/0");
        await test.Until(() => main.Paths.IsChosen && main.Recovery is not null && main.Properties.Thing is not null);
        await main.Convergence.Load();
        foreach (string tab in new[] { "scene", "gallery", "files" })
        {
            main.Layout.OpenLeft(tab);
            yield return tab;
        }

        foreach (string tab in new[] { "source", "paths", "maps", "convergence", "times" })
        {
            main.Layout.OpenDock(tab);
            yield return tab;
        }

        foreach (string tab in new[] { "object", "camera", "render", "world" })
        {
            main.Properties.Open(tab);
            yield return tab;
        }

        main.Messages.Say("error", "Something is wrong.");
        yield return "message";
        foreach (DialogViewModel dialog in Dialogs())
        {
            main.Ask(dialog);
            yield return dialog.GetType().Name;
            dialog.Cancel.Execute(null);
            Assert.Null(main.Dialog);
        }

    }

    private static IEnumerable<DialogViewModel> Dialogs() =>
    [
        new UnsavedViewModel("a", () => Task.FromResult(true), () => { }), new OverwriteViewModel("b", () => { }), new RenameViewModel("c", _ => { }),
        new ExportViewModel((_, _, _) => { }), new ShortcutsViewModel(), new TourViewModel(),
    ];
}
