using System.Runtime.InteropServices;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Platform;
using Avalonia.VisualTree;
using RayTracer.Desktop.Controls;
using RayTracer.Desktop.ViewModels;
using RayTracer.Desktop.Views;
using RayTracer.Session;

namespace RayTracer.Desktop.Tests;

/// <summary>What the session changes is seen in the controls, and what is done to the controls changes the session.</summary>
public sealed class BindingTests
{
    [Fact]
    public void The_picture_on_the_screen_is_the_newest_frame_to_the_byte() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        await test.Until(() => test.Main.Status.Fraction == 1);
        test.Do("actualSize");
        test.Session.View.Tone = new(1, RayTracer.Description.ToneMap.Aces);
        FrameView view = test.View<ViewportView>().FindControl<FrameView>("Picture")!;
        byte[] wanted = new byte[4 * 60 * 40];
        await test.Until(() =>
        {
            using FrameLease frame = test.Session.View.Frames.Borrow()!;
            FramePixels.Write(frame.Picture, test.Session.View.Tone, 1, wanted);
            return Pixels(view).AsSpan().SequenceEqual(wanted);
        }, "the picture is shown");
        test.Layout();
        Assert.Equal((60, 40), (view.Bounds.Width, view.Bounds.Height));
    });

    [Fact]
    public void Text_problems_and_outline_follow_the_document_and_typing_reaches_it() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        TextBox editor = test.View<SourceView>().FindControl<TextBox>("Editor")!;
        Assert.Equal(test.Session.Document.Text, editor.Text);
        string good = editor.Text!;
        editor.Text = good.Replace("\"sphere\"", "\"spere\"", StringComparison.Ordinal);
        await test.Until(() => test.Session.Document.Text == editor.Text && test.Main.Source.HasProblems);
        test.Layout();
        ListBox problems = test.View<SourceView>().GetVisualDescendants().OfType<ListBox>().First();
        Assert.Contains(problems.GetVisualDescendants().OfType<TextBlock>(), t => t.Text!.Contains("sphere", StringComparison.Ordinal));
        problems.SelectedIndex = 0;
        Assert.Equal("\"spere\"", editor.SelectedText);
        Assert.True(test.Main.Viewport.IsLastGood);
        editor.Text = good;
        await test.Until(() => !test.Main.Source.HasProblems && !test.Main.Viewport.IsLastGood);

        int rows = test.View<OutlinerView>().GetVisualDescendants().OfType<ListBox>().First().ItemCount;
        test.Session.Edits.Add("light", "sphere");
        await test.Until(() => test.View<OutlinerView>().GetVisualDescendants().OfType<ListBox>().First().ItemCount == rows + 1);
        await test.Until(() => editor.Text == test.Session.Document.Text);
    });

    [Fact]
    public void Choosing_a_line_of_the_outliner_shows_its_properties_and_a_typed_number_reaches_the_text() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        ListBox list = test.View<OutlinerView>().GetVisualDescendants().OfType<ListBox>().First();
        list.SelectedItem = test.Main.Outliner.Rows.First(r => r.Pointer == "/shapes/3");
        await test.Until(() => test.Main.Properties.Thing?.Pointer == "/shapes/3");
        test.Layout();
        NumberFieldViewModel radius = test.Main.Properties.Thing!.Record!.Fields.OfType<NumberFieldViewModel>().First(f => f.Parameter.Key == "radius");
        CommitBox box = test.Seen<CommitBox>().First(b => b.DataContext == radius);
        Assert.Equal(radius.Text, box.Text);
        box.Text = "0,75";
        box.Commit();
        await test.Until(() => test.Session.Document.Text.Contains("\"radius\": 0.75", StringComparison.Ordinal));
        test.Session.Edits.Set("/shapes/3/radius", 1.25);
        await test.Until(() => box.Text == "1.25");
        NumberFieldViewModel angle = (NumberFieldViewModel)test.Main.Properties.Camera.Record!.Fields.First(f => f.Parameter.Key == "fieldOfView");
        test.Main.Properties.Open("camera");
        test.Layout();
        NumberSlider slider = test.Seen<NumberSlider>().First(s => s.DataContext == angle);
        Assert.Equal(37, slider.Value);
        slider.RaiseEvent(new KeyEventArgs { RoutedEvent = InputElement.KeyDownEvent, Key = Key.Right });
        await test.Until(() => test.Session.Document.Text.Contains($"\"fieldOfView\": {angle.Text}", StringComparison.Ordinal) && angle.Value > 37);
        test.Main.Properties.Open("object");
        box.Text = "nonsense";
        box.Commit();
        Assert.Equal("1.25", box.Text);

        // Another thing in the same panel: the controls are used again, and nothing is written.
        string text = test.Session.Document.Text;
        foreach (string pointer in new[] { "/lights/0", "/shapes/1", "/shapes/2" })
        {
            test.Session.Selection.Select(pointer);
            await test.Until(() => test.Main.Properties.Thing?.Pointer == pointer);
            test.Layout();
        }

        await test.Main.Dispatcher.Idle;
        Assert.Equal(text, test.Session.Document.Text);
    });

    [Fact]
    public void A_field_of_every_kind_shows_what_is_written_and_writes_what_is_chosen() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        test.Session.Edits.SetText("/materials", """{ "m": { "type": "principled", "baseColor": "red" }, "g": { "type": "dielectric" } }""");
        test.Session.Edits.SetText("/shapes/0", """{ "type": "sphere", "center": [0, 1, 0], "radius": 0.5, "material": "m", "transform": [{ "translate": [1, 0, 0] }] }""");
        test.Session.Selection.Select("/shapes/0");
        RecordViewModel Record() => test.Main.Properties.Thing!.Record!;
        T Field<T>(string key)
            where T : FieldViewModel => Record().Fields.OfType<T>().First(f => f.Parameter.Key == key);
        await test.Until(() => test.Main.Properties.Thing is { Record: not null } && Field<KindFieldViewModel>("material").IsNamed);
        Assert.Equal("1", Field<VectorFieldViewModel>("center").Components[1].Text);
        Field<VectorFieldViewModel>("center").Components[1].Text = "2";
        await test.Until(() => Written(test, "[0, 2, 0]"));
        Assert.Single(Field<StepsFieldViewModel>("transform").Steps);
        Field<StepsFieldViewModel>("transform").Add.Execute(null);
        await test.Until(() => Field<StepsFieldViewModel>("transform").Steps.Count == 2);
        Field<StepsFieldViewModel>("transform").Steps[1].Remove.Execute(null);
        await test.Until(() => Field<StepsFieldViewModel>("transform").Steps.Count == 1);
        Assert.True(Field<StepsFieldViewModel>("transform").CanReset);
        Field<StepsFieldViewModel>("transform").Reset.Execute(null);
        await test.Until(() => Field<StepsFieldViewModel>("transform") is { CanReset: false, Steps.Count: 0 });
        KindFieldViewModel material = Field<KindFieldViewModel>("material");
        material.Chosen = material.Choices.First(c => c.Value == "type:plastic");
        await test.Until(() => Field<KindFieldViewModel>("material").Inner is RecordViewModel { Type.Name: "plastic" });

        test.Session.Selection.Select("/materials/m");
        await test.Until(() => test.Main.Properties.Thing?.Pointer == "/materials/m");
        KindFieldViewModel color = Field<KindFieldViewModel>("baseColor");
        Assert.IsType<ColorFieldViewModel>(color.Inner).Name = "#00ff00";
        await test.Until(() => Written(test, "#00ff00"));
        KindFieldViewModel roughness = Field<KindFieldViewModel>("roughness");
        roughness.Chosen = roughness.Choices.First(c => c.Value == "type:checker");
        await test.Until(() => Field<KindFieldViewModel>("roughness").Inner is RecordViewModel { Type.Name: "checker" });
        test.Main.Properties.Thing!.Type = test.Main.Properties.Thing.Types.First(t => t.Value == "dielectric");
        await test.Until(() => test.Main.Properties.Thing?.Record?.Type.Name == "dielectric");
        NumberFieldViewModel index = Field<NumberFieldViewModel>("refractiveIndex");
        index.Substance = index.Substances.First(s => s.Value.Length > 0 && s != index.Substance);
        await test.Until(() => Written(test, $"\"refractiveIndex\": {Field<NumberFieldViewModel>("refractiveIndex").Text}"));
        test.Layout();
        Assert.DoesNotContain(test.Main.Messages.All, m => m.IsError);
    });

    [Fact]
    public void Camera_rendering_and_world_are_set_in_their_tabs() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        (PropertyPanelViewModel panel, RenderViewModel render) = (test.Main.Properties, test.Main.Properties.Render);
        panel.Open("render");
        test.Layout();
        ComboBox[] boxes = [.. test.View<RenderView>().GetVisualDescendants().OfType<ComboBox>()];
        Assert.Equal(render.Quality, boxes[0].SelectedItem);
        boxes[0].SelectedItem = render.Qualities[0];
        await test.Until(() => test.Session.View.Settings.Quality == RenderQuality.Draft);
        boxes[1].SelectedItem = render.PictureSizes.First(s => s.Value == "400x300");
        await test.Until(() => test.Session.View.Loop.Status is { Width: 400, Height: 300 } && (boxes[1].SelectedItem as Choice)?.Value == "400x300");
        render.Threads = "1";
        await test.Until(() => test.Session.View.Settings.Threads == 1 && render.Threads == "1");

        panel.Open("camera");
        ((NumberFieldViewModel)panel.Camera.Record!.Fields.First(f => f.Parameter.Key == "fieldOfView")).Text = "50";
        await test.Until(() => Written(test, "\"fieldOfView\": 50"));
        panel.Open("world");
        panel.Environment.Chosen = panel.Environment.Choices.First(c => c.Value == "sky");
        await test.Until(() => panel.Environment.Record?.Type.Name == "sky" && panel.World.All(w => w.Pointer != "/background"));
        test.Layout();
        panel.Environment.Chosen = panel.Environment.Choices[0];
        await test.Until(() => panel.Environment.Record is null && panel.World.Any(w => w.Pointer == "/background"));
    });

    [Fact]
    public void Title_status_jobs_and_messages_are_shown() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        await test.Until(() => test.Main.Status.Fraction == 1);
        Assert.Equal($"test.json – {SessionTexts.Of("product")}", test.Window.Title);
        ProgressBar progress = test.View<StatusView>().GetVisualDescendants().OfType<ProgressBar>().First();
        Assert.Equal(1, progress.Value);

        test.Session.Jobs.Start("waiting", (report, stop) =>
        {
            report.Report(0.5);
            stop.WaitHandle.WaitOne();
            stop.ThrowIfCancellationRequested();
            return "";
        });
        await test.Until(() => test.Main.Status.Jobs is [{ Fraction: 0.5 }]);
        test.Layout();
        Assert.Contains(test.Seen<TextBlock>(), t => t.Text == "waiting");
        test.Main.Status.Jobs[0].Cancel.Execute(null);
        await test.Until(() => test.Main.Status.Jobs.Count == 0 && test.Main.Messages.All.Count == 1);
        test.Layout();
        Assert.Equal("waiting: cancelled", test.Main.Messages.All[0].Text);
        Assert.Contains(test.View<MessagesView>().GetVisualDescendants().OfType<TextBlock>(), t => t.Text == "waiting: cancelled");
        test.Main.Messages.All[0].Dismiss.Execute(null);
        Assert.Empty(test.Main.Messages.All);
        test.Session.Edits.Set("/camera/fieldOfView", 30);
        await test.Until(() => test.Window.Title!.StartsWith('•'));
    });

    [Fact]
    public void Paths_and_convergence_are_shown_as_a_table_and_a_plot() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open(samples: 16);
        await test.Until(() => test.Main.Status.Fraction == 1);
        test.Main.Viewport.Inspect(new(30, 20));
        await test.Until(() => test.Main.Paths.IsChosen);
        test.Layout();
        PathsView paths = test.View<PathsView>();
        Assert.Equal(test.Main.Paths.Samples.Count, paths.GetVisualDescendants().OfType<ListBox>().First().ItemCount);
        Assert.Contains(paths.GetVisualDescendants().OfType<TextBlock>(), t => t.Text == test.Main.Paths.Vertices[1].Throughput);
        test.Main.Paths.Chosen = test.Main.Paths.Samples[3];
        Assert.Equal(Figures.Color(test.Main.Paths.Samples[3].Path.Radiance), test.Main.Paths.Total);

        test.Main.Layout.OpenDock("convergence");
        await test.Main.Convergence.Load();
        test.Layout();
        Avalonia.Controls.Shapes.Polyline[] lines = [.. test.View<ConvergenceView>().GetVisualDescendants().OfType<Avalonia.Controls.Shapes.Polyline>()];
        Assert.Equal([4, 4], lines.Select(l => l.Points.Count));
        Assert.True(lines[1].Points[0].Y < lines[1].Points[^1].Y, "the error shrinks");
        Assert.StartsWith("Measured slope", test.Main.Convergence.Slope, StringComparison.Ordinal);
    });

    [Fact]
    public void Dark_and_light_are_chosen_by_the_command_and_change_the_colours() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        MainWindow window = App.Open(test.Session);
        MainViewModel main = (MainViewModel)window.DataContext!;
        object? Foreground() => window.TryFindResource("SystemControlForegroundBaseHighBrush", window.ActualThemeVariant, out object? brush) ? brush?.ToString() : null;
        main.Commands["theme"].Execute(null);
        Assert.Equal("Light", window.ActualThemeVariant.Key);
        object? light = Foreground();
        main.Commands["theme"].Execute(null);
        Assert.Equal("Dark", window.ActualThemeVariant.Key);
        Assert.NotEqual(light, Foreground());
        main.Commands["theme"].Execute(null);
        window.CloseAnyway();
    });

    private static bool Written(TestWindow test, string text) => test.Session.Document.Text.Contains(text, StringComparison.Ordinal);

    private static byte[] Pixels(FrameView view)
    {
        if (view.Bitmap is not { } bitmap)
        {
            return [];
        }

        using ILockedFramebuffer pixels = bitmap.Lock();
        byte[] bytes = new byte[pixels.RowBytes * pixels.Size.Height];
        Marshal.Copy(pixels.Address, bytes, 0, bytes.Length);
        return bytes;
    }
}
