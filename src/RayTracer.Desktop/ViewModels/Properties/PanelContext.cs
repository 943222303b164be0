using System.Text.Json.Nodes;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The rest of the window, as editors of parameters use it.</summary>
/// <param name="dispatcher">Carries changes to the session.</param>
/// <param name="window">Asks for files.</param>
internal sealed class PanelContext(SessionDispatcher dispatcher, IWindowServices window)
{
    private readonly Dictionary<string, Latest<Setting>> _settings = new(StringComparer.Ordinal);

    public static TypeCatalogue Catalogue => TypeCatalogue.Instance;

    /// <summary>The outline of the scene; null before it could be read.</summary>
    public Outline? Outline { get; set; }

    /// <summary>The folder of the scene's file; null where it has none.</summary>
    public string? Folder { get; set; }

    /// <summary>Shows a part of the source.</summary>
    public Action<TextPlace> ShowSource { get; set; } = _ => { };

    /// <summary>Writes a value; while one is on its way, only the newest of the same place waits.</summary>
    public void Set(string pointer, JsonNode? value, string? gesture = null)
    {
        if (!_settings.TryGetValue(pointer, out Latest<Setting>? latest))
        {
            _settings.Add(pointer, latest = new(s => dispatcher.Attempt(() => dispatcher.Ask(session => session.Edits.Set(s.Pointer, s.Value, s.Gesture)))));
        }

        latest.Push(new(pointer, value?.DeepClone(), gesture ?? Gesture.New()));
    }

    /// <summary>Takes a value out of the text.</summary>
    public void Reset(string pointer) => dispatcher.Do(s => s.Edits.Reset(pointer));

    /// <summary>Takes an element out of a list.</summary>
    public void Delete(string pointer) => dispatcher.Do(s => s.Edits.Delete(pointer));

    /// <summary>Selects a thing.</summary>
    public void Select(string pointer) => dispatcher.Do(s => s.Selection.Select(pointer));

    /// <summary>Shows where a thing is written.</summary>
    public void ShowInSource(string pointer) => _ = dispatcher.Attempt(async () =>
    {
        PropertyValues values = await dispatcher.Ask(s => PropertyValues.At(s.Document.Readable.Root, pointer));
        ShowSource(new(values.From, values.To));
    });

    /// <summary>Asks for a picture or a model that the scene shall name, and passes on its name relative to the scene's folder.</summary>
    public void ChooseFile(Action<string> chosen) => _ = dispatcher.Attempt(async () =>
    {
        if (await window.ChooseFile(SessionTexts.Of("dialogs.chooseTitle"), Folder, []) is { } path)
        {
            chosen(Folder is null ? path : Path.GetRelativePath(Folder, path).Replace('\\', '/'));
        }
    });

    private sealed record Setting(string Pointer, JsonNode? Value, string Gesture);
}
