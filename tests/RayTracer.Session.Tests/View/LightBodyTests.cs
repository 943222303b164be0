using System.Numerics;
using RayTracer.Lights;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

public sealed class LightBodyTests
{
    private const string Scene = """
        {
          "camera": { "position": [0, 2, 8], "lookAt": [0, 1, 0] },
          "render": { "integrator": "path", "width": 120, "height": 80, "samplesPerPixel": 1 },
          "environment": { "type": "sky" },
          "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0] }, { "type": "sphere", "center": [1, 0.5, 0], "radius": 0.5 } ],
          "lights": [
            { "type": "point", "position": [-1, 2, 0] },
            { "type": "spot", "position": [0, 3, 0], "direction": [0, -1, 0], "cutoffAngle": 20 },
            { "type": "directional", "direction": [-1, -2, -1] },
            { "type": "sphere", "center": [2, 2, 0], "radius": 0.25, "material": { "type": "luminaire" } }
          ]
        }
        """;

    [Fact]
    public async Task Each_light_has_a_place_and_its_handles()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Scene);
        Dictionary<string, LightBody> bodies = LightBody.Of(shown).ToDictionary(b => b.Kind);
        Assert.Equal(["area", "directional", "point", "spot", "sun"], bodies.Keys.Order());
        Assert.Equal(CameraFrame.Of(shown).Project(new(-1, 2, 0))!.Value, bodies["point"].Place);
        Assert.Empty(bodies["point"].Handles);
        Assert.Equal([LightHandleKind.Direction, LightHandleKind.Cone, LightHandleKind.Beam], bodies["spot"].Handles.Select(h => h.Kind));
        Assert.Equal([LightHandleKind.Direction], bodies["directional"].Handles.Select(h => h.Kind));
        Assert.Equal([LightHandleKind.Radius], bodies["area"].Handles.Select(h => h.Kind));
        Assert.Equal("/environment", bodies["sun"].Pointer);
    }

    [Fact]
    public async Task Handles_that_stay_where_they_are_change_nothing_that_can_be_seen()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Scene);
        foreach (LightBody body in LightBody.Of(shown))
        {
            foreach (LightHandle handle in body.Handles.Where(h => !(body.Kind == "spot" && h.Kind == LightHandleKind.Direction)))
            {
                test.Session.LightHandles.Drag(new(body.Pointer, handle.Kind, handle.At, "stay"));
            }
        }

        shown = await Shown(test);
        SpotLightDescription spot = shown.Description.Lights.OfType<SpotLightDescription>().Single();
        Assert.Equal(20, spot.CutoffAngle, 0.2f);
        Assert.Equal(15, spot.BeamWidth!.Value, 0.2f);
        Vector3 sun = shown.Description.Lights.OfType<DirectionalLightDescription>().Single().Direction;
        Assert.True(Vector3.Dot(Vector3.Normalize(sun), Vector3.Normalize(new(-1, -2, -1))) > 0.99999f);
        SkyEnvironmentDescription sky = Assert.IsType<SkyEnvironmentDescription>(shown.Description.Environment);
        Assert.Equal((40, 45), (sky.SunElevation, sky.SunAzimuth), (a, b) => MathF.Abs(a.Item1 - b.Item1) < 0.2f && MathF.Abs(a.Item2 - b.Item2) < 0.2f);
        Assert.Contains("\"radius\": 0.25", test.Session.Document.Text, StringComparison.Ordinal);
        test.Session.Document.Undo();
        Assert.False(test.Session.Document.Status.CanUndo);
    }

    [Fact]
    public async Task A_spot_is_aimed_at_what_is_under_the_pointer_and_widened_with_few_digits()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Scene);
        Vector2 ball = CameraFrame.Of(shown).Project(new(1, 0.5f, 0.5f))!.Value;
        test.Session.LightHandles.Drag(new("/lights/1", LightHandleKind.Direction, ball, "aim"));
        shown = await Shown(test);
        Vector3 direction = shown.Description.Lights.OfType<SpotLightDescription>().Single().Direction;
        Vector3 hit = Picking.At(shown, ball.X, ball.Y).Position!.Value;
        Assert.True(Vector3.Dot(Vector3.Normalize(direction), Vector3.Normalize(hit - new Vector3(0, 3, 0))) > 0.99999f);
        LightBody body = LightBody.Of(shown).Single(b => b.Kind == "spot");
        Vector2 cone = body.Handles.Single(h => h.Kind == LightHandleKind.Cone).At;
        test.Session.LightHandles.Drag(new("/lights/1", LightHandleKind.Cone, cone + ((cone - body.Place) * 0.01f) + new Vector2(6, 0), "widen"));
        shown = await Shown(test);
        float wide = shown.Description.Lights.OfType<SpotLightDescription>().Single().CutoffAngle;
        Assert.InRange(wide, 21, 60);
        Assert.Equal(wide, MathF.Round(wide, 1), 1e-4f);
    }

    [Fact]
    public async Task Lights_and_endless_things_have_move_handles_and_what_is_no_light_has_none_of_a_lights()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Scene);
        CameraFrame camera = CameraFrame.Of(shown);
        Assert.Equal(3, Gizmo.Of(shown, "/lights/0").Handles(camera, GizmoKind.Move, 20).Handles.Count);
        Assert.Empty(Gizmo.Of(shown, "/lights/0").Handles(camera, GizmoKind.Rotate, 20).Handles);
        Assert.Equal(3, Gizmo.Of(shown, "/lights/2").Handles(camera, GizmoKind.Rotate, 20).Handles.Count);
        Assert.Null(Gizmo.Of(shown, "/lights/2").Handles(camera, GizmoKind.Scale, 20).Center);
        Assert.Equal(3, Gizmo.Of(shown, "/shapes/0").Handles(camera, GizmoKind.Move, 20).Handles.Count);
        Assert.Throws<SessionException>(() => test.Session.LightHandles.Drag(new("/shapes/1", LightHandleKind.Radius, new(3, 3), "g")));
        Assert.Throws<SessionException>(() => test.Session.LightHandles.Drag(new("/lights/0", LightHandleKind.Cone, new(3, 3), "g")));
        Assert.Throws<SessionException>(() => test.Session.LightHandles.Drag(new("/lights/9", LightHandleKind.Cone, new(3, 3), "g")));
    }

    private static async Task<ViewportScene> Shown(TestSession test)
    {
        await test.Session.Document.WhenBuilt();
        return await test.Until(() => test.Session.View.Shown!.Good.Revision == test.Session.Document.Revision ? test.Session.View.Shown : null);
    }
}
