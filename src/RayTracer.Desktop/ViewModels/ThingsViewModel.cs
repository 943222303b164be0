using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Adds, copies, renames and deletes things of the scene.</summary>
/// <param name="dispatcher">Carries it to the session.</param>
/// <param name="context">Asks for files.</param>
/// <param name="showTab">Shows a tab of the properties.</param>
internal sealed class ThingsViewModel(SessionDispatcher dispatcher, PanelContext context, Action<string> showTab)
{
    /// <summary>The things that can be added.</summary>
    public IReadOnlyList<AddGroup> Families { get; private set; } = [];

    /// <summary>The selected thing, if it is one that can be copied, renamed and deleted.</summary>
    public string? Selected { get; set; }

    /// <summary>Lists what can be added.</summary>
    public void Load()
    {
        string[] families = ["shape", "light", "environment", "material", "texture"];
        CatalogueType[] types = [.. PanelContext.Catalogue.Types.Values.SelectMany(t => t)];
        Families = [.. families.Select(f => new AddGroup(
            SessionTexts.Of($"families.{f}"),
            [.. types.Where(t => t.AddedAs.Contains(f)).OrderBy(t => t.AddedAs.Count).Select(t => new AddItem(Figures.Spaced(t.Name), t.Summary, new RelayCommand(() => Add(f, t))))]))];
    }

    /// <summary>Adds a thing; one that cannot be without a file asks for it first.</summary>
    public void Add(string family, CatalogueType type)
    {
        if (type.Parameters.Any(p => p.Required && p.Kind == "file"))
        {
            context.ChooseFile(file => Put(family, type, file));
        }
        else
        {
            Put(family, type, null);
        }
    }

    /// <summary>Makes a copy of the selected thing.</summary>
    public void Duplicate() => With(pointer => dispatcher.Do(s => s.Selection.SelectAll([.. s.Edits.Duplicate(pointer).Pointers])));

    /// <summary>Deletes the selected thing.</summary>
    public void Delete() => With(pointer => dispatcher.Do(s => s.Edits.Delete(pointer)));

    /// <summary>Does something with the selected thing, if there is one.</summary>
    public void With(Action<string> work)
    {
        if (Selected is { } pointer)
        {
            work(pointer);
        }
    }

    /// <summary>Gives a thing another name.</summary>
    public void Rename(string pointer, string name) => dispatcher.Do(s => s.Edits.Rename(pointer, name));

    private void Put(string family, CatalogueType type, string? file)
    {
        showTab(family == "environment" ? "world" : "object");
        dispatcher.Do(s =>
        {
            string pointer = s.Edits.Add(family, type.Name, file: file).Pointer;
            s.Selection.Select(SceneThings.IsThing(pointer) ? pointer : null);
        });
    }
}

/// <summary>Things of one family that can be added.</summary>
/// <param name="Name">The family.</param>
/// <param name="Items">The things.</param>
internal sealed record AddGroup(string Name, IReadOnlyList<AddItem> Items);

/// <summary>A thing that can be added.</summary>
/// <param name="Name">The name.</param>
/// <param name="Tip">A description of it.</param>
/// <param name="Add">Adds it.</param>
internal sealed record AddItem(string Name, string Tip, ICommand Add);
