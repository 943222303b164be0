using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Opens, saves and shares; asks before anything is lost.</summary>
/// <param name="dispatcher">Carries it to the session.</param>
/// <param name="window">Asks for files, and has the clipboard.</param>
/// <param name="ask">Shows a question.</param>
internal sealed class FileCommands(SessionDispatcher dispatcher, IWindowServices window, Action<DialogViewModel> ask)
{
    private static readonly string[] CanBeOpened = ["json", "zip", "xml", "obj", "ply", "stl", "gltf", "glb", "off", "3ds"];

    /// <summary>The document's status; set by the window.</summary>
    public DocumentStatus? Document { get; set; }

    /// <summary>Ends when all that was typed is with the session.</summary>
    public Func<Task> Flush { get; set; } = () => Task.CompletedTask;

    private string Name => Document?.Name ?? "scene.json";

    private string? Folder => Document?.Path is { } path ? Path.GetDirectoryName(path) : null;

    /// <summary>Asks for a file and opens it.</summary>
    public Task Open() => dispatcher.Attempt(async () =>
    {
        if (await window.ChooseFile(SessionTexts.Of("dialogs.openTitle"), Folder, CanBeOpened) is { } path)
        {
            await OpenFile(path);
        }
    });

    /// <summary>Opens a file.</summary>
    public Task OpenFile(string path) => Leaving((s, discard) => s.Files.Open(path, discard));

    /// <summary>Opens a shipped scene.</summary>
    public Task OpenGallery(string id) => Leaving((s, discard) => s.Files.OpenGallery(id, discard));

    /// <summary>Opens a text that was not saved.</summary>
    public Task OpenRecovered(string id) => Leaving((s, discard) => s.Files.OpenRecovered(id, discard));

    /// <summary>Begins a new scene.</summary>
    public Task New() => Leaving((s, discard) => s.Files.New(discard));

    /// <summary>Closes the window.</summary>
    /// <returns>True if it may close at once; else the user is asked.</returns>
    public bool Close()
    {
        if (Document?.IsDirty != true)
        {
            return true;
        }

        ask(new UnsavedViewModel(Name, Save, window.Close));
        return false;
    }

    /// <summary>Saves the document; returns whether it is saved.</summary>
    public async Task<bool> Save() =>
        Document?.Path is null ? await SaveAs() : await Writing((s, overwrite) => s.Files.Save(null, overwrite));

    /// <summary>Asks where to, and saves the document.</summary>
    public async Task<bool> SaveAs() =>
        await window.ChooseNewFile(SessionTexts.Of("dialogs.saveTitle"), Folder, Name) is { } path && await Writing((s, _) => s.Files.Save(path, overwrite: true));

    /// <summary>Asks where to, and writes the picture.</summary>
    /// <param name="format">The format's extension, without its dot.</param>
    /// <param name="bitDepth">Bits a channel.</param>
    /// <param name="layers">The names of auxiliary images to write too.</param>
    public Task Export(string format, int bitDepth, IEnumerable<string> layers) => dispatcher.Attempt(async () =>
    {
        if (await window.ChooseNewFile(SessionTexts.Of("dialogs.exportTitle"), Folder, Path.ChangeExtension(Name, format)) is { } path)
        {
            await dispatcher.Aside(s => s.Pictures.Save(s.Pictures.Job(path, bitDepth, layers), overwrite: true));
        }
    });

    /// <summary>Asks where to, and writes the scene with all files that it names.</summary>
    public Task Bundle() => dispatcher.Attempt(async () =>
    {
        await Flush();
        if (await window.ChooseNewFile(SessionTexts.Of("commands.bundle.0"), Folder, Path.ChangeExtension(Name, "zip")) is { } path)
        {
            await dispatcher.Ask(s =>
            {
                using FileStream zip = File.Create(path);
                SceneBundle.Write(zip, JsonText.Of(s.Document.Read), s.Document.Place);
                return true;
            });
        }
    });

    /// <summary>Puts the picture on the clipboard.</summary>
    public Task CopyPicture() => dispatcher.Attempt(async () =>
    {
        await window.CopyPicture(await dispatcher.Aside(s => s.Pictures.Encode(s.Pictures.Job(Path.ChangeExtension(s.Document.Place.Name, ".png")), CancellationToken.None)));
        dispatcher.Messages.Say("info", SessionTexts.Of("messages.copiedImage"));
    });

    /// <summary>Puts the command that renders exactly this on the clipboard.</summary>
    public Task CopyCommand() => dispatcher.Attempt(async () =>
    {
        string command = await dispatcher.Ask(s => s.Pictures.Command());
        await window.CopyText(command);
        dispatcher.Messages.Say("info", SessionTexts.Of("messages.copiedCommand", command));
    });

    // Does what would lose changes; asks first where there are some.
    private Task Leaving(Action<StudioSession, bool> step) => dispatcher.Attempt(async () =>
    {
        await Flush();
        try
        {
            await Step(step, discard: false);
        }
        catch (SessionException e) when (e.Fault == SessionFault.Unsaved)
        {
            ask(new UnsavedViewModel(Name, Save, () => _ = dispatcher.Attempt(() => Step(step, discard: true))));
        }
    });

    private Task<bool> Step(Action<StudioSession, bool> step, bool discard) => dispatcher.Ask(s =>
    {
        step(s, discard);
        return true;
    });

    // Writes something; asks before a file is replaced that is not the one that was opened.
    private async Task<bool> Writing(Func<StudioSession, bool, string> write)
    {
        bool isWritten = false;
        await dispatcher.Attempt(async () =>
        {
            await Flush();
            try
            {
                await dispatcher.Ask(s => write(s, false));
                isWritten = true;
            }
            catch (SessionException e) when (e.Fault is SessionFault.Exists or SessionFault.ChangedOnDisk)
            {
                ask(new OverwriteViewModel(Complaint.Of(e)!, () => _ = dispatcher.Attempt(() => dispatcher.Ask(s => write(s, true)))));
            }
        });
        return isWritten;
    }
}
