-- | The film that a scene file and the options make together.
module BlackHole.Cli.FilmScene
  ( loadFilm,
    resolveFilm,
    frameFaults,
    maximumFaults,
  )
where

import BlackHole.Animation.Film
import BlackHole.Animation.FilmFile
import BlackHole.Animation.Progress (frameRanges)
import BlackHole.Cli.SceneOptions
import BlackHole.Scene.File.Yaml
import BlackHole.Scene.Problem
import qualified Data.ByteString as Bytes
import Data.Either (fromRight)
import Data.Foldable (fold)
import Data.List (sortOn)
import qualified Data.Map.Strict as Map

-- | The film that the options ask for, given the bytes of its file, or a line
-- for everything that is wrong with its scene and its section on animation; but
-- see 'frameFaults'. 'Nothing' if there is no such section.
resolveFilm :: SceneOptions -> Maybe Bytes.ByteString -> Either [String] (Maybe Film)
resolveFilm options bytes = case (resolveScene options bytes, section) of
  (Left problems, _) -> Left (problems ++ sectionFaults)
  (_, Just (_, _ : _)) -> Left sectionFaults
  (Right scene, Just (film, [])) -> Right (Just (film scene))
  (Right _, Nothing) -> Right Nothing
  where
    -- A file that is no YAML has been complained of with the scene.
    section = bytes >>= fromRight Nothing . parseYaml >>= readAnimation
    sectionFaults =
      [ concat [fold (sceneFile options), ":", show line, ": ", renderProblem problem]
        | (line, problem) <- sortOn fst (maybe [] snd section)
      ]

-- | The same, reading the file.
loadFilm :: SceneOptions -> IO (Either [String] (Maybe Film))
loadFilm options = do
  bytes <- traverse readSceneFile (sceneFile options)
  pure (either (Left . pure) (resolveFilm options) (sequence bytes))

-- | Everything that is wrong with the scenes of some frames (in growing order);
-- what is wrong with several in the same way is said once.
frameFaults :: Film -> [Int] -> [String]
frameFaults film frames =
  [ (if length wrong == 1 then "frame " else "frames ") ++ frameRanges (reverse wrong) ++ ": " ++ text
    | (text, wrong) <- sortOn (lastOf . snd) (Map.toList faults)
  ]
  where
    faults =
      Map.fromListWith
        (++)
        [ (renderProblem problem, [n])
          | n <- frames,
            Left problems <- [frameScenes film n],
            problem <- problems
        ]
    lastOf = foldl (const Just) Nothing

-- | As many of them as somebody will want to read.
maximumFaults :: Int
maximumFaults = 20
