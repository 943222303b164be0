using System.Text.Json.Nodes;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>An editor for each parameter of a record, in the schema's order.</summary>
internal sealed class RecordViewModel
{
    /// <summary>Editors for a record.</summary>
    /// <param name="context">What they need of the rest.</param>
    /// <param name="type">The record's type.</param>
    /// <param name="pointer">Where it stands.</param>
    /// <param name="without">Parameters that are shown elsewhere.</param>
    public RecordViewModel(PanelContext context, CatalogueType type, string pointer, IReadOnlyCollection<string> without)
    {
        (Type, Pointer) = (type, pointer);
        Fields = [.. type.Parameters.Where(p => !without.Contains(p.Key)).Select(p => FieldViewModel.Of(context, p, JsonPointer.Append(pointer, p.Key)))];
    }

    /// <summary>The record's type.</summary>
    public CatalogueType Type { get; }

    /// <summary>Where it stands.</summary>
    public string Pointer { get; }

    /// <summary>What it is.</summary>
    public string Summary => Type.Summary;

    /// <summary>The editors.</summary>
    public IReadOnlyList<FieldViewModel> Fields { get; }

    /// <summary>Shows what is written.</summary>
    public void Show(JsonNode? value)
    {
        foreach (FieldViewModel field in Fields)
        {
            field.Show((value as JsonObject)?[field.Parameter.Key]);
        }
    }
}
