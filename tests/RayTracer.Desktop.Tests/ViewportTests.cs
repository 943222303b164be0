using RayTracer.Desktop.ViewModels;
using RayTracer.Session;

namespace RayTracer.Desktop.Tests;

/// <summary>Pointer, wheel and keys in the picture.</summary>
public sealed class ViewportTests
{
    [Fact]
    public void Dragging_orbits_pans_and_looks_and_the_scene_stays() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        ViewportViewModel viewport = test.Main.Viewport;
        string text = test.Session.Document.Text;
        CameraPose scenes = CameraPose.Of(test.Session.View.Shown!.Camera);
        foreach ((PointerButton button, HeldKeys keys, Func<CameraPose, object> changed) in new (PointerButton, HeldKeys, Func<CameraPose, object>)[]
        {
            (PointerButton.Main, HeldKeys.None, p => p.Position), (PointerButton.Main, HeldKeys.Shift, p => p.LookAt), (PointerButton.Second, HeldKeys.None, p => p.LookAt), (PointerButton.Middle, HeldKeys.None, p => p.Position),
        })
        {
            viewport.Press(new(300, 200), button, keys);
            viewport.Move(new(320, 205));
            viewport.Move(new(350, 210));
            viewport.Release(new(350, 210));
            await test.Until(() => !changed(CameraPose.Of(test.Session.View.Shown!.Camera)).Equals(changed(scenes)));
            test.Do("home");
            await test.Until(() => test.Session.View.IsSceneCamera, "the scene's camera is where it was");
            Assert.Equal(text, test.Session.Document.Text);
        }
    });

    [Fact]
    public void Wheel_and_keys_move_the_camera_and_the_enlarged_picture() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        ViewportViewModel viewport = test.Main.Viewport;
        Stage fitting = viewport.Stage;
        Spot under = fitting.ToPicture(new(200, 100));
        viewport.Turn(new(200, 100), 1, HeldKeys.Mod);
        Assert.True(viewport.Stage.Scale > 1.4 * fitting.Scale);
        Assert.True(viewport.Stage.ToPicture(new(200, 100)).DistanceTo(under) < 1, "what is under the pointer stays");
        viewport.Press(new(200, 100), PointerButton.Main, HeldKeys.Space);
        viewport.Move(new(230, 100));
        viewport.Release(new(230, 100));
        Assert.True(viewport.Stage.ToPicture(new(230, 100)).DistanceTo(under) < 1, "the picture follows the hand");
        Assert.False(test.Session.Document.IsDirty);

        foreach (Action act in new Action[] { () => viewport.Turn(new(200, 100), 1, HeldKeys.None), () => viewport.Turn(new(200, 100), 1, HeldKeys.Alt), () => viewport.Key("ArrowLeft", HeldKeys.None), () => viewport.Key("w", HeldKeys.None) })
        {
            CameraPose before = CameraPose.Of(test.Session.View.Shown!.Camera);
            act();
            await test.Until(() => CameraPose.Of(test.Session.View.Shown!.Camera) != before);
        }

        Assert.False(viewport.Key("z", HeldKeys.Mod));
        test.Do("home");
        await test.Until(() => test.Session.View.IsSceneCamera);
    });

    [Fact]
    public void A_click_selects_and_outlines_what_is_there() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        ViewportViewModel viewport = test.Main.Viewport;
        Spot? ball = null;
        for (int i = 0; i < 60 * 40 && ball is null; i++)
        {
            ball = Picking.At(test.Session.View.RequireShown(), i % 60, i / 60).Pointer == "/shapes/1" ? new(i % 60, i / 60) : null;
        }

        Spot at = viewport.Stage.ToScreen(new Spot(ball!.Value.X + 0.5, ball.Value.Y + 0.5));
        viewport.Press(at, PointerButton.Main, HeldKeys.None);
        viewport.Release(at);
        await test.Until(() => test.Session.Selection.Pointer == "/shapes/1" && viewport.Outline is not null && test.Main.Outliner.Chosen?.Pointer == "/shapes/1");
        Assert.Contains((byte)255, viewport.Outline!.Rgba);

        test.Do("toolInspect");
        viewport.Press(at, PointerButton.Main, HeldKeys.None);
        viewport.Release(at);
        await test.Until(() => test.Main.Paths.IsChosen && viewport.Mark.IsVisible);
        test.Do("toolFocus");
        viewport.Press(at, PointerButton.Main, HeldKeys.None);
        viewport.Release(at);
        await test.Until(() => test.Session.Document.Text.Contains("focusDistance", StringComparison.Ordinal));
    });

    [Fact]
    public void A_region_is_drawn_rendered_and_cleared() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        ViewportViewModel viewport = test.Main.Viewport;
        test.Do("toolRegion");
        Spot from = viewport.Stage.ToScreen(new Spot(10, 10));
        Spot to = viewport.Stage.ToScreen(new Spot(30, 25));
        viewport.Press(from, PointerButton.Main, HeldKeys.None);
        viewport.Move(to);
        Assert.True(viewport.Region.IsVisible);
        viewport.Release(to);
        await test.Until(() => test.Session.View.Settings.Region is { X: 10, Y: 10, Width: >= 20, Height: >= 15 } && viewport.HasRegion);
        Assert.Equal(Tool.Select, viewport.Tool);
        Assert.True(viewport.Region.Width > 1);
        viewport.ClearRegion.Execute(null);
        await test.Until(() => !viewport.HasRegion && !viewport.Region.IsVisible);
    });

    [Theory]
    [InlineData("toolMove")]
    [InlineData("toolRotate")]
    [InlineData("toolScale")]
    public void Handles_move_turn_and_scale_the_selected_shape(string tool) => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        test.Session.Edits.SetText("/shapes/0", """{ "type": "box", "a": [-0.5, 0, -0.5], "b": [0.5, 1, 0.5] }""");
        test.Session.Selection.Select("/shapes/0");
        ViewportViewModel viewport = test.Main.Viewport;
        test.Do(tool);
        await test.Until(() => viewport.Gizmo.Handles.Count(h => h.Axis is not null) == 3);
        string before = test.Session.Document.Text;
        HandleViewModel handle = viewport.Gizmo.Handles.First(h => h.Axis == 1);
        Spot at = handle.Points[tool == "toolRotate" ? 5 : ^1];
        viewport.Press(at, PointerButton.Main, HeldKeys.None);
        viewport.Move(new(at.X + 20, at.Y - 30));
        viewport.Move(new(at.X + 25, at.Y - 45));
        viewport.Release(new(at.X + 25, at.Y - 45));
        await test.Until(() => test.Session.Document.Text != before && test.Main.Dispatcher.Idle.IsCompleted);
        Assert.Equal("place", test.Session.Document.Status.UndoLabel);
        test.Do("undo");
        await test.Until(() => test.Session.Document.Text == before, "one step takes it back");
    });

    [Fact]
    public void Exposure_tone_map_and_what_is_shown_reach_the_view() => Ui.Run(async () =>
    {
        using TestWindow test = await TestWindow.Open();
        ViewportViewModel viewport = test.Main.Viewport;
        viewport.ExposureText = "1.5";
        viewport.ToneMap = viewport.ToneMaps.First(t => t.Value == "Aces");
        await test.Until(() => test.Session.View.Tone == new Tone(1.5f, RayTracer.Description.ToneMap.Aces));
        viewport.Rule = viewport.ExposureRules.First(r => r.Value == "Auto");
        await test.Until(() => test.Session.View.Tone.Exposure == RayTracer.Description.Exposure.Auto && viewport.Exposure == test.Session.View.Stops);
        viewport.Rule = viewport.ExposureRules.First(r => r.Value == "Stops");
        await test.Until(() => test.Session.View.Tone.Exposure == (float)viewport.Exposure);
        viewport.Map = viewport.Maps.First(m => m.Value == "normal");
        await test.Until(() => test.Session.View.Settings.Map == ViewMap.Named("normal") && viewport.Map?.Value == "normal");
        viewport.Zoom = viewport.Zooms.First(z => z.Value == "200");
        Assert.Equal(2, viewport.Stage.Scale, 1e-9);
    });
}
