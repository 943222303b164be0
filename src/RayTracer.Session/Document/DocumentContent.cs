using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>A document as it was at one moment: its text, and what the text came to.</summary>
/// <param name="Revision">Grows with every change of the text.</param>
/// <param name="Text">The scene file's text.</param>
/// <param name="Read">What was read from it: nodes with their places, records, diagnostics.</param>
/// <param name="Load">The scene built from it, and all diagnostics.</param>
/// <param name="LastGood">The newest content, this or an earlier one, from which a scene could be built; null before there was one.</param>
public sealed record DocumentContent(int Revision, string Text, SceneReadResult Read, SceneLoadResult Load, GoodScene? LastGood);

/// <summary>A scene that can be shown, and where it came from.</summary>
/// <param name="Revision">The document's revision.</param>
/// <param name="Text">The text then.</param>
/// <param name="Read">What was read from it.</param>
/// <param name="Scene">The scene.</param>
public sealed record GoodScene(int Revision, string Text, SceneReadResult Read, Scene Scene);
