using RayTracer.Desktop.ViewModels;

namespace RayTracer.Desktop.Tests;

/// <summary>What is not saved is not lost without a question.</summary>
public sealed class ClosingTests
{
    [Fact]
    public void A_window_without_changes_closes_at_once() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        test.Window.Close();
        Assert.True(test.IsClosed);
    });

    [Fact]
    public void Closing_with_unsaved_changes_asks_and_may_be_taken_back() => Ui.Run(async () =>
    {
        using TestWindow test = await Changed();
        test.Window.Close();
        Assert.False(test.IsClosed);
        UnsavedViewModel question = Assert.IsType<UnsavedViewModel>(test.Main.Dialog);
        Assert.Contains("test.json", question.Text, StringComparison.Ordinal);
        question.Cancel.Execute(null);
        Assert.Null(test.Main.Dialog);
        Assert.False(test.IsClosed);
        test.Window.Close();
        Assert.IsType<UnsavedViewModel>(test.Main.Dialog).Discard.Execute(null);
        Assert.True(test.IsClosed);
    });

    [Fact]
    public void Saving_at_the_question_saves_and_then_closes() => Ui.Run(async () =>
    {
        using TestWindow test = await Changed();
        test.Window.Close();
        test.Services.Chosen = null;
        Assert.IsType<UnsavedViewModel>(test.Main.Dialog).Save.Execute(null);
        await test.Until(() => test.Services.Titles.Count == 1);
        Assert.False(test.IsClosed);
        test.Window.Close();
        test.Services.Chosen = test["kept.json"];
        Assert.IsType<UnsavedViewModel>(test.Main.Dialog).Save.Execute(null);
        await test.Until(() => test.IsClosed);
        Assert.Equal(test.Session.Document.Text, File.ReadAllText(test["kept.json"]));
    });

    [Fact]
    public void Opening_another_scene_with_unsaved_changes_asks_first() => Ui.Run(async () =>
    {
        using TestWindow test = await Changed();
        string text = test.Session.Document.Text;
        test.Main.Gallery.Groups[0].Items[0].Open.Execute(null);
        await test.Until(() => test.Main.Dialog is not null);
        Assert.Equal(text, test.Session.Document.Text);
        Assert.IsType<UnsavedViewModel>(test.Main.Dialog).Discard.Execute(null);
        await test.Until(() => test.Main.DocumentName == "one.json" && !test.Main.IsDirty);
    });

    [Fact]
    public void What_an_earlier_session_left_is_offered() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        await test.Until(() => test.Main.Recovery is not null);
        test.Main.Recovery!.Open.Execute(null);
        await test.Until(() => test.Session.Document.Text.StartsWith("// kept", StringComparison.Ordinal) && test.Main.Recovery is null && test.Main.IsDirty);
    });

    private static async Task<TestWindow> Changed()
    {
        TestWindow test = await TestWindow.Open();
        test.Session.Edits.Set("/camera/fieldOfView", 33);
        await test.Until(() => test.Main.IsDirty);
        return test;
    }
}
